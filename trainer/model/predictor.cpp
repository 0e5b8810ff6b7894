#include "trainer/model/predictor.h"

#include <stdexcept>

#include "trainer/calibration/certified_lens.h"
#include "trainer/deepcalib/sphere_head.h"
#include "trainer/fit/fit_head.h"
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
  if (is_fit(card_.options.head)) {
    std::vector<Outputs> means;
    for (const LensPosterior& posterior : posteriors(images)) means.push_back(posterior.mean);
    return means;
  }
  std::vector<Outputs> predicted = run_network(*network_, images, card_);
  for (Outputs& outputs : predicted) outputs = unstandardise(outputs, card_.targets);
  return predicted;
}

void Predictor::require_fit() const {
  if (!is_fit(card_.options.head))
    throw std::runtime_error("model: its head " + to_string(card_.options.head) +
                             " has no fit: choose a model trained with --head fit");
}

std::vector<LensPosterior> Predictor::posteriors(std::span<const BatchImage> images) const {
  require_fit();
  const torch::Tensor rows = run_head(*network_, images, card_);
  const std::size_t width = row_width(card_.options.head);
  std::vector<LensPosterior> result;
  for (std::size_t i = 0; i < images.size(); ++i) {
    result.push_back(posterior_of({rows.data_ptr<float>() + i * width, width}, card_));
    Outputs& mean = result.back().mean;
    mean = pulled_to_one_to_one(mean, card_.options.target_space, images[i].original);
  }
  return result;
}

std::vector<FrameEvidence> Predictor::evidence(std::span<const BatchImage> images) const {
  require_fit();
  return run_evidence(*network_, images, card_);
}

std::vector<SphereTarget> Predictor::spheres(std::span<const BatchImage> images) const {
  if (!is_deepcalib(card_.options.head))
    throw std::runtime_error("model: its head " + to_string(card_.options.head) +
                             " predicts no unified spherical lens: choose another model");
  return sphere_targets(card_.options.head, run_head(*network_, images, card_));
}

}  // namespace cps
