#include "trainer/evaluation/predicted_cameras.h"

#include "trainer/calibration/targets.h"

namespace cps {

std::optional<ModelCamera> predicted_camera(const Outputs& outputs, TargetSpace space,
                                            const ImageSize& size) {
  const std::optional<CalibratedCamera> camera = to_camera(outputs, space, size.width, size.height);
  if (!camera) return std::nullopt;
  return model_camera(*camera);
}

std::vector<std::optional<ModelCamera>> predicted_cameras(const Predictor& predictor,
                                                          std::span<const BatchImage> images) {
  const TrainOptions& options = predictor.card().options;
  std::vector<std::optional<ModelCamera>> cameras;
  if (is_deepcalib(options.head)) {
    const std::vector<SphereTarget> spheres = predictor.spheres(images);
    for (std::size_t i = 0; i < images.size(); ++i)
      cameras.push_back(to_model_camera(spheres[i], images[i].original.width, images[i].original.height));
    return cameras;
  }
  const std::vector<Outputs> outputs = predictor(images);
  for (std::size_t i = 0; i < images.size(); ++i)
    cameras.push_back(predicted_camera(outputs[i], options.target_space, images[i].original));
  return cameras;
}

std::optional<ModelCamera> training_mean_camera(const ModelCard& card, const ImageSize& size) {
  if (is_deepcalib(card.options.head)) return to_model_camera(card.spheres.mean, size.width, size.height);
  return predicted_camera(card.targets.mean, card.options.target_space, size);
}

}  // namespace cps
