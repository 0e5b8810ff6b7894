#include "trainer/fit/one_camera.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "numbers/quantile.h"
#include "trainer/fit/joint_fit.h"
#include "trainer/fit/robust_weights.h"

namespace cps {
namespace {

constexpr std::size_t fewest_to_outvote = 3;

/// The frames with their weights, and what these were found by.
struct JudgedFrames {
  std::vector<WeighedFrame> frames;
  double tilt_scatter = 1;
};

/// Lowers the precisions of the directly read numbers so that those of all frames together have the variance
/// that OneCameraOptions::common_share says. Frames count as often as they weigh.
void share_direct_numbers(std::vector<WeighedFrame>& frames, double common_share) {
  double count = 0;
  for (const WeighedFrame& frame : frames) count += frame.weight;
  const double share = 1 / (1 + common_share * std::max(0.0, count - 1));
  for (WeighedFrame& frame : frames)
    frame.evidence.prior.precision.topLeftCorner<output_count, output_count>() *= share;
}

JudgedFrames unjudged(std::span<const CameraFrame> frames, const OneCameraOptions& options) {
  JudgedFrames all;
  for (const CameraFrame& frame : frames) all.frames.push_back({frame.evidence});
  share_direct_numbers(all.frames, options.common_share);
  return all;
}

/// The squared Mahalanobis distance over the outputs between what the frame says alone and the parameters, by
/// the frame's equations there.
double squared_distance(const FrameEvidence& frame, const FitVector& parameters, const Outputs& scale) {
  const OutputEquations alone = without_angles(frame_equations(frame, parameters));
  const OutputVector step = Eigen::LLT<OutputCovariance>(alone.information).solve(alone.pull),
                     off = step.cwiseQuotient(OutputVector::Map(scale.data()));
  return off.dot(alone.information * off);
}

double scatter_of(const std::vector<std::vector<double>>& residuals) {
  std::vector<double> known;
  for (const std::vector<double>& of_frame : residuals)
    std::ranges::copy_if(of_frame, std::back_inserter(known), [](double r) { return std::isfinite(r); });
  constexpr double smallest = 1e-3;  // below, edges agree as well as anyone needs
  return known.empty() ? 1 : std::max(smallest, robust_deviation(std::move(known)));
}

JudgedFrames judged_at(std::span<const CameraFrame> frames, const std::vector<FitVector>& parameters,
                       const OneCameraOptions& options) {
  std::vector<std::vector<double>> residuals(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t i) { residuals[i] = tilt_residuals(frames[i].evidence, parameters[i]); });
  JudgedFrames judged{std::vector<WeighedFrame>(frames.size()), scatter_of(residuals)};
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    WeighedFrame& frame = judged.frames[i];
    frame.evidence = frames[i].evidence;
    weigh_down(frame.evidence.edges, residuals[i], judged.tilt_scatter, options.degrees_of_freedom);
    frame.weight = student_weight(squared_distance(frame.evidence, parameters[i], options.deviation_scale),
                                  output_count, options.degrees_of_freedom);
  });
  share_direct_numbers(judged.frames, options.common_share);
  return judged;
}

/// The median of the frames' outputs, with each frame's own angles.
std::vector<FitVector> start_of(std::span<const CameraFrame> frames) {
  std::vector<FitVector> start;
  for (const CameraFrame& frame : frames) {
    if (!frame.alone.allFinite())
      throw std::runtime_error("one camera: the network's numbers are not finite: train it again");
    start.push_back(frame.alone);
  }
  for (int k = 0; k < output_count; ++k) {
    std::vector<double> values;
    for (const CameraFrame& frame : frames) values.push_back(frame.alone[k]);
    const double middle = quantile(std::move(values), .5);
    for (FitVector& parameters : start) parameters[k] = middle;
  }
  return start;
}

LensPosterior joint_posterior(const JointFit& fit, const ImageSize& picture, const Outputs& scale) {
  LensPosterior posterior;
  OutputVector::Map(posterior.mean.data()) = fit.parameters.front().head<output_count>();
  posterior.mean = pulled_to_one_to_one(posterior.mean, TargetSpace::seen, picture);
  const OutputVector by = OutputVector::Map(scale.data());
  const OutputCovariance covariance =
      Eigen::LLT<OutputCovariance>(fit.information).solve(OutputCovariance::Identity());
  posterior.covariance = by.asDiagonal() * covariance * by.asDiagonal();
  return posterior;
}

}  // namespace

std::string OneCameraOptions::fault() const {
  if (!(common_share >= 0 && common_share <= 1)) return "common-share: must lie in [0, 1]";
  if (!(degrees_of_freedom > 0 && std::isfinite(degrees_of_freedom)))
    return "degrees-of-freedom: must be above 0";
  if (rounds < 0 || rounds > 100) return "rounds: must lie in [0, 100]";
  const auto is_positive = [](double factor) { return factor > 0 && std::isfinite(factor); };
  return std::ranges::all_of(deviation_scale, is_positive) ? "" : "deviation-scale: must be above 0";
}

int OneCamera::trusted_frames() const {
  return static_cast<int>(
      std::ranges::count_if(frames, [](const FrameInCamera& frame) { return frame.weight >= .5; }));
}

std::vector<CameraFrame> fit_each(std::vector<FrameEvidence> frames) {
  std::vector<CameraFrame> fitted(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    fitted[i].alone = fit_lens(frames[i]).parameters;
    fitted[i].evidence = std::move(frames[i]);
  });
  return fitted;
}

OneCamera fit_one_camera(std::span<const CameraFrame> frames, const OneCameraOptions& options) {
  const int rounds = frames.size() < fewest_to_outvote ? 0 : options.rounds;
  std::vector<FitVector> start = start_of(frames);
  JudgedFrames judged = rounds == 0 ? unjudged(frames, options) : judged_at(frames, start, options);
  JointFit fit = fit_jointly(judged.frames, std::move(start));
  for (int round = 1; round < rounds; ++round) {
    judged = judged_at(frames, fit.parameters, options);
    fit = fit_jointly(judged.frames, std::move(fit.parameters));
  }

  const ImageSize& picture = frames.front().evidence.edges.picture;
  OneCamera result;
  result.posterior = joint_posterior(fit, picture, options.deviation_scale);
  result.certified = pull_to_certified(
      to_camera(result.posterior.mean, TargetSpace::seen, picture.width, picture.height).value());
  result.tilt_scatter = judged.tilt_scatter;
  for (std::size_t i = 0; i < frames.size(); ++i)
    result.frames.push_back({fit.parameters[i][pitch_parameter], fit.parameters[i][roll_parameter],
                             fit.parameters[i][yaw_parameter], judged.frames[i].weight});
  return result;
}

}  // namespace cps
