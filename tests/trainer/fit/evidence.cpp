#include "tests/trainer/fit/evidence.h"

#include <cmath>

#include "numbers/angles.h"
#include "trainer/calibration/seen_hfov.h"

namespace cps {

LensPrior wide_prior(const ImageSize& picture) {
  FitVector mean, deviation;
  mean << radians(75), -.1, .02, -.002, 0, 0, .5 * (picture.width - 1) / picture.width,
      .5 * (picture.height - 1) / picture.height, 0, 0, 0;
  deviation << radians(8), .08, .03, .006, .004, .004, .015, .02, angle_deviation[0], angle_deviation[1],
      angle_deviation[2];
  return {mean, FitMatrix(deviation.cwiseAbs2().cwiseInverse().asDiagonal())};
}

FitVector drawn(const LensPrior& prior, Stream stream) {
  for (int attempt = 0;; ++attempt) {
    const Stream numbers = substream(stream, attempt);
    FitVector result = prior.mean;
    for (int i = 0; i < fit_parameter_count; ++i)
      result[i] += random_normal(numbers, i) / std::sqrt(prior.precision(i, i));
    Outputs outputs;
    for (int i = 0; i < output_count; ++i) outputs[i] = result[i];
    if (ideal_radius(outputs, 1).slope > .15) return result;
  }
}

FrameEvidence synthetic_evidence(const LensPrior& prior, const FitVector& truth, const ImageSize& picture,
                                 double weight, Stream stream) {
  const ImageSize orientation{87, 32}, grid = fit_grid(orientation);
  const std::size_t blocks = static_cast<std::size_t>(edge_families) * grid.width * grid.height;
  FrameEvidence frame{prior,
                      {picture, grid, std::vector<float>(blocks, 1), std::vector<float>(blocks)},
                      fit_block_centres(picture, orientation)};
  const TiltModel model = tilt_model(frame, truth);
  const Stream weights = make_stream(stream.key, "weights"), errors = make_stream(stream.key, "errors");
  for (std::size_t i = 0; i < blocks; ++i) {
    const double drawn_weight = 2 * random_uniform(weights, i) - 1;
    const double w = model.has_tilt[i] && drawn_weight > 0 ? weight * drawn_weight : 0;
    frame.edges.weight[i] = static_cast<float>(w);
    frame.edges.weighted_tilt[i] =
        w > 0 ? static_cast<float>(w * (model.tilt[i] + random_normal(errors, i) / std::sqrt(w))) : 0;
  }
  return frame;
}

}  // namespace cps
