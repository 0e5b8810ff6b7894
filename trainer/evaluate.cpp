#include "trainer/evaluate.h"

#include <stdexcept>

#include "trainer/samples.h"

namespace cps {
namespace {

/// What the truth says, once per group.
struct GroupTruth {
  Calibration calibration;
  RayGrid rays;
};

std::vector<GroupTruth> truth_of_groups(const Dataset& dataset) {
  std::vector<GroupTruth> truths;
  for (const DatasetGroup& group : dataset.groups) {
    const Calibration calibration{group.label.camera, group.label.distortion};
    auto rays = ray_grid(calibration);
    if (!rays)
      throw std::runtime_error((dataset.root / group.folder / "calibration.json").string() +
                               ": the lens is not one-to-one in its frame: cps verify tells more");
    truths.push_back({calibration, std::move(*rays)});
  }
  return truths;
}

Outputs centred_without_distortion(double fov, const Pinhole& camera) {
  return to_outputs({pinhole_from_hfov(camera.width, camera.height, fov), {}}, TargetSpace::raw);
}

}  // namespace

Evaluation evaluate(const Predictor& predictor, const Dataset& dataset, Part part) {
  const ModelCard& card = predictor.card();
  const TargetSpace space = card.options.target_space;
  const std::vector<GroupTruth> truths = truth_of_groups(dataset);
  const Samples samples = load_samples(dataset, part, space, card.options.reduction, {});
  std::vector<BatchImage> images;
  for (std::size_t i = 0; i < samples.targets.size(); ++i)
    images.push_back({samples.cache.images[i], samples.cache.originals[i]});
  const std::vector<Outputs> said = predictor(images);

  std::vector<LensVerdict> network, mean, centre;
  const std::vector<int> members = images_of(dataset, part);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const GroupTruth& truth = truths[dataset.images[members[i]].group];
    const Pinhole& camera = truth.calibration.camera;
    const auto raw = [&](const Outputs& outputs) {
      return convert(outputs, space, TargetSpace::raw, camera.width, camera.height);
    };
    network.push_back({&truth.calibration, &truth.rays, raw(said[i])});
    mean.push_back({&truth.calibration, &truth.rays, raw(card.targets.mean)});
    centre.push_back(
        {&truth.calibration, &truth.rays, centred_without_distortion(card.targets.mean[0], camera)});
  }
  return {.model = {},
          .dataset = dataset.root.string(),
          .part = part,
          .network = measure_errors(network),
          .training_mean = measure_errors(mean),
          .centre = measure_errors(centre)};
}

}  // namespace cps
