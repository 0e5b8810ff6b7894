#include "trainer/model/half_model.h"

#include <stdexcept>

#include "trainer/model/predictor.h"
#include "trainer/network/weights.h"

namespace cps {

void write_half_model(const std::filesystem::path& model_folder, const std::filesystem::path& copy) {
  if (std::filesystem::exists(copy / "model.json") && !load_model_card(copy).has_half_weights)
    throw std::runtime_error(copy.string() + ": holds a model with float32 weights: name another folder");
  const Predictor predictor(model_folder);
  const NamedTensors weights = half_weights_of(predictor.network(), model_folder / "weights.pt");
  ModelCard card = predictor.card();
  card.has_half_weights = true;
  save_tensors(weights, copy / "weights.pt");
  save_model_card(card, copy);
}

}  // namespace cps
