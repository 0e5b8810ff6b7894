#include "trainer/evaluation/evaluate_rays.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <stdexcept>

#include "trainer/evaluation/predicted_cameras.h"
#include "trainer/evaluation/read_pictures.h"

namespace cps {
namespace {

ImageSize size_of(const RayImage& image) {
  const Pinhole& pinhole = image.truth->camera.pinhole;
  return {pinhole.width, pinhole.height};
}

std::vector<RayEvaluatedImage> judge_rays(const Predictor& predictor, const RaySet& set,
                                          const ReadPictures& read) {
  std::vector<BatchImage> batch;
  for (std::size_t k = 0; k < read.kept.size(); ++k)
    batch.push_back(batch_image(read.images[k], size_of(set.images[read.kept[k]])));
  const std::vector<std::optional<ModelCamera>> cameras = predicted_cameras(predictor, batch);
  std::vector<RayEvaluatedImage> judged(cameras.size());
  tbb::parallel_for(std::size_t{0}, judged.size(), [&](std::size_t k) {
    const RayImage& image = set.images[read.kept[k]];
    judged[k] = {image, cameras[k], ray_errors(*image.truth, cameras[k]),
                 ray_errors(*image.truth, training_mean_camera(predictor.card(), size_of(image)))};
  });
  return judged;
}

}  // namespace

RayEvaluation evaluate_rays(const Predictor& predictor, const RaySet& set, const EvaluationOptions& options) {
  std::vector<SizedPicture> pictures;
  for (const RayImage& image : set.images) pictures.push_back({image.file, size_of(image)});
  const ReadPictures read = read_pictures(pictures, predictor.card().options, options.skip_bad_images);
  if (read.images.empty()) throw std::runtime_error(set.name + ": no image is left to measure");
  RayEvaluation result{.model = {},
                       .set = set.name,
                       .comparison = {},
                       .images = judge_rays(predictor, set, read),
                       .skipped = read.skipped};
  std::vector<RayErrors> network, mean;
  std::vector<int> clusters;
  std::vector<std::string> cameras;
  for (const RayEvaluatedImage& image : result.images) {
    network.push_back(image.network);
    mean.push_back(image.training_mean);
    clusters.push_back(image.image.cluster);
    cameras.push_back(image.image.camera);
  }
  result.comparison = compare_rays(network, mean, clusters, cameras, options.resamples, options.seed);
  return result;
}

std::string RayEvaluation::report() const {
  std::string text = fmt::format("{} {}, model {}\n", comparison.network.images, set, model);
  for (const std::string& why : skipped) text += "left out: " + why + "\n";
  return text + cps::report(comparison);
}

}  // namespace cps
