#include "trainer/model/predictor.h"

#include <stdexcept>

#include "trainer/deepcalib/sphere_head.h"
#include "trainer/model/make_network.h"
#include "trainer/network/inference.h"
#include "trainer/network/weights.h"

namespace cps {

Predictor::Predictor(const std::filesystem::path& model_folder, Device device)
    : card_(load_model_card(model_folder)) {
  network_ = make_network(card_.options);
  const std::filesystem::path file = model_folder / "weights.pt";
  set_weights(*network_, load_tensors(file), file);
  network_->to(to_torch(device));
}

std::vector<Outputs> Predictor::operator()(std::span<const BatchImage> images) const {
  if (is_deepcalib(card_.options.head))
    throw std::runtime_error("model: its head " + to_string(card_.options.head) +
                             " predicts no Brown-Conrady lens: choose another model");
  std::vector<Outputs> predicted = run_network(*network_, images, card_);
  for (Outputs& outputs : predicted) outputs = unstandardise(outputs, card_.targets);
  return predicted;
}

std::vector<SphereTarget> Predictor::spheres(std::span<const BatchImage> images) const {
  if (!is_deepcalib(card_.options.head))
    throw std::runtime_error("model: its head " + to_string(card_.options.head) +
                             " predicts no unified spherical lens: choose another model");
  return sphere_targets(card_.options.head, run_last_layer(*network_, images, card_));
}

}  // namespace cps
