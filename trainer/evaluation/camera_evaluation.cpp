#include "trainer/evaluation/camera_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/angles.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/fit/one_camera.h"

namespace cps {
namespace {

/// The images of each camera, by their places.
std::vector<std::vector<std::size_t>> by_camera(std::span<const EvaluatedImage> images) {
  std::vector<std::vector<std::size_t>> cameras;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const EvaluationImage& image = images[i].image;
    const auto known = std::ranges::find_if(cameras, [&](const std::vector<std::size_t>& members) {
      const EvaluationImage& first = images[members.front()].image;
      return first.taken_by == image.taken_by && first.truth == image.truth;
    });
    if (known == cameras.end())
      cameras.push_back({i});
    else
      known->push_back(i);
  }
  return cameras;
}

/// The mean of the single frames' errors, over those that have one.
template <typename Error>
double mean_of_singles(std::span<const EvaluatedImage> images, const std::vector<std::size_t>& members,
                       Error error) {
  double sum = 0;
  int count = 0;
  for (std::size_t i : members) {
    const std::optional<double> value = error(images[i].network);
    if (!value) continue;
    sum += *value;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

CameraEvaluation evaluate_camera(std::span<const EvaluatedImage> images,
                                 const std::vector<std::size_t>& members, const OneCamera& fitted) {
  const EvaluationImage& image = images[members.front()].image;
  const Pinhole& pinhole = image.truth.pinhole;
  const auto in = [&](TargetSpace space) {
    return convert(fitted.posterior, TargetSpace::seen, space, pinhole.width, pinhole.height);
  };
  CameraEvaluation result;
  result.name = image.taken_by;
  result.truth = image.truth;
  result.predicted = in(TargetSpace::raw).mean;
  result.frames = static_cast<int>(members.size());
  result.trusted_frames = fitted.trusted_frames();
  const ImageErrors joint = image_errors({&image.truth, image.rays.get(), result.predicted});
  const Outputs deviation = in(TargetSpace::apparent).deviation();
  const auto singles = [&](auto error) { return mean_of_singles(images, members, error); };
  result.hfov_deg = {joint.hfov_deg, singles([](const ImageErrors& e) { return std::optional(e.hfov_deg); }),
                     degrees(deviation[0])};
  result.k1 = {std::abs(joint.apparent[1]),
               singles([](const ImageErrors& e) { return std::optional(std::abs(e.apparent[1])); }),
               deviation[1]};
  result.reprojection_px = {joint.reprojection_px.value_or(INFINITY),
                            singles([](const ImageErrors& e) { return e.reprojection_px; })};
  return result;
}

}  // namespace

std::vector<CameraEvaluation> evaluate_cameras(const Predictor& predictor,
                                               std::span<const EvaluatedImage> images,
                                               std::span<const BatchImage> batch) {
  const std::vector<CameraFrame> frames = fit_each(predictor.evidence(batch));
  std::vector<CameraEvaluation> cameras;
  for (const std::vector<std::size_t>& members : by_camera(images)) {
    std::vector<CameraFrame> of_camera;
    for (std::size_t i : members) of_camera.push_back(frames[i]);
    cameras.push_back(evaluate_camera(
        images, members, fit_one_camera(of_camera, {.deviation_scale = predictor.card().deviation_scale})));
  }
  return cameras;
}

}  // namespace cps
