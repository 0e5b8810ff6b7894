#include "trainer/fit/fit_head.h"

#include <ATen/ATen.h>
#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "trainer/calibration/seen_hfov.h"

namespace cps {
namespace {

using torch::Tensor;

/// Bounds of the logarithms that the network says, so that no exponential overflows.
constexpr double min_log_variance = -9, max_log_variance = 3, max_log_weight = 8;

/// The network's numbers and weighted edges of a batch, double, on the CPU, with gradients.
struct BatchEvidence {
  Tensor mean;                   ///< [n, 8], standardised
  Tensor precision;              ///< [n, 8, 8], standardised: the said variances, the targets' correlation
  Tensor weight, weighted_tilt;  ///< [n, 2 · blocks], sums over the fit's blocks, in the order of EdgeBlocks
};

/// The measured sums of the images' edges, [n, 2, h'', w''].
std::pair<Tensor, Tensor> measured_sums(std::span<const BatchImage> images) {
  const ImageSize grid = weight_grid(images.front().orientation.grid);
  const long n = static_cast<long>(images.size());
  const Tensor weight = torch::empty({n, edge_families, grid.height, grid.width}),
               weighted_tilt = torch::empty_like(weight);
  float *weights = weight.data_ptr<float>(), *tilts = weighted_tilt.data_ptr<float>();
  for (const BatchImage& image : images) {
    const EdgeBlocks edges = measured_edges(image);
    weights = std::ranges::copy(edges.weight, weights).out;
    tilts = std::ranges::copy(edges.weighted_tilt, tilts).out;
  }
  return {weight, weighted_tilt};
}

/// Sums over the blocks of the fit, [n, 2 · blocks].
Tensor block_sums(const Tensor& cells) {
  return at::avg_pool2d(cells.to(torch::kDouble), weights_per_block, weights_per_block, 0, true, false, 1)
      .flatten(1);
}

/// The correlation's inverse.
Tensor inverse_correlation(const ModelCard& card) {
  const OutputCovariance inverse =
      card.correlation.inverse();  // symmetric: its storage order does not matter
  return torch::tensor(std::vector<double>(inverse.data(), inverse.data() + inverse.size()), torch::kDouble)
      .view({output_count, output_count});
}

/// The precision of the outputs' prior for logarithms of variances, [n, 8].
Tensor output_precision(const Tensor& log_variance, const ModelCard& card) {
  const Tensor inverse_deviation = (log_variance * -.5).exp();
  return inverse_deviation.unsqueeze(2) * inverse_correlation(card) * inverse_deviation.unsqueeze(1);
}

BatchEvidence batch_evidence(const NetworkOutput& output, std::span<const BatchImage> images,
                             const ModelCard& card) {
  const Tensor numbers = output.numbers.to(torch::kCPU, torch::kDouble);
  const Tensor weights = output.edge_weights.cpu().clamp(-max_log_weight, max_log_weight).exp();
  const auto [weight, weighted_tilt] = measured_sums(images);
  const Tensor log_variance =
      numbers.narrow(1, output_count, output_count).clamp(min_log_variance, max_log_variance);
  return {numbers.narrow(1, 0, output_count), output_precision(log_variance, card),
          block_sums(weight * weights), block_sums(weighted_tilt * weights)};
}

/// What each parameter is measured in: the outputs' deviations, the angles' own.
FitVector units(const Standardisation& by) {
  FitVector result;
  for (int i = 0; i < output_count; ++i) result[i] = by.deviation[i];
  for (int i = 0; i < 3; ++i) result[output_count + i] = angle_deviation[i];
  return result;
}

FitVector zero_points(const Standardisation& by) {
  FitVector result = FitVector::Zero();
  for (int i = 0; i < output_count; ++i) result[i] = by.mean[i];
  return result;
}

std::vector<FrameEvidence> frames_of(const BatchEvidence& batch, std::span<const BatchImage> images,
                                     const ModelCard& card) {
  const Tensor mean = batch.mean.detach().contiguous(), precision = batch.precision.detach().contiguous(),
               weight = batch.weight.detach().to(torch::kFloat).contiguous(),
               weighted_tilt = batch.weighted_tilt.detach().to(torch::kFloat).contiguous();
  const auto means = mean.accessor<double, 2>();
  const auto precisions = precision.accessor<double, 3>();
  const FitVector unit = units(card.targets), zero = zero_points(card.targets);
  const ImageSize orientation = images.front().orientation.grid;
  const long blocks = weight.size(1);
  std::vector<FrameEvidence> frames(images.size());
  for (std::size_t n = 0; n < images.size(); ++n) {
    const long row = static_cast<long>(n);
    FrameEvidence& frame = frames[n];
    frame.prior.mean = zero;
    frame.prior.precision = unit.cwiseAbs2().cwiseInverse().asDiagonal();
    for (int i = 0; i < output_count; ++i) {
      frame.prior.mean[i] += unit[i] * means[row][i];
      for (int k = 0; k < output_count; ++k)
        frame.prior.precision(i, k) = precisions[row][i][k] / (unit[i] * unit[k]);
    }
    const float *weights = weight.data_ptr<float>() + row * blocks,
                *tilts = weighted_tilt.data_ptr<float>() + row * blocks;
    frame.edges = {
        images[n].original, fit_grid(orientation), {weights, weights + blocks}, {tilts, tilts + blocks}};
    frame.centres = fit_block_centres(images[n].original, orientation);
  }
  return frames;
}

/// Where fit_lens() ended for each image, in units(): constants for the last step.
struct FittedPoints {
  Tensor parameters;  ///< [n, 11]
  Tensor slopes;      ///< [n, 2 · blocks, 11]
  Tensor tilts;       ///< [n, 2 · blocks]
};

FittedPoints fitted_points(std::span<const FrameEvidence> frames, const Standardisation& by) {
  const long n = static_cast<long>(frames.size()),
             blocks = static_cast<long>(frames.front().edges.weight.size());
  const FittedPoints points{torch::empty({n, fit_parameter_count}, torch::kDouble),
                            torch::empty({n, blocks, fit_parameter_count}, torch::kDouble),
                            torch::empty({n, blocks}, torch::kDouble)};
  double *parameters = points.parameters.data_ptr<double>(), *slopes = points.slopes.data_ptr<double>(),
         *tilts = points.tilts.data_ptr<double>();
  const FitVector unit = units(by), zero = zero_points(by);
  tbb::parallel_for(0l, n, [&](long i) {
    const LensFit fit = fit_lens(frames[i]);
    FitVector::Map(parameters + i * fit_parameter_count) = (fit.parameters - zero).cwiseQuotient(unit);
    std::ranges::copy(fit.model.tilt, tilts + i * blocks);
    for (long block = 0; block < blocks; ++block)
      FitVector::Map(slopes + (i * blocks + block) * fit_parameter_count) =
          FitVector::Map(&fit.model.slope[block * fit_parameter_count]).cwiseProduct(unit);
  });
  return points;
}

/// The prior of all parameters in units(), [n, 11, 11]: the angles' precision is 1.
Tensor with_angles(const Tensor& precision) {
  const Tensor angles = at::diag(torch::tensor({0., 0., 0., 0., 0., 0., 0., 0., 1., 1., 1.}, torch::kDouble));
  return at::constant_pad_nd(precision, {0, 3, 0, 3}) + angles;
}
/// Parameters [n, 11] and their covariance [n, 11, 11], with gradients.
std::pair<Tensor, Tensor> last_step(const BatchEvidence& batch, const FittedPoints& at_points) {
  const Tensor precision = with_angles(batch.precision), mean = at::constant_pad_nd(batch.mean, {0, 3});
  const Tensor weighted_slopes = at_points.slopes * batch.weight.unsqueeze(2);
  const Tensor information = at_points.slopes.transpose(1, 2).matmul(weighted_slopes) + precision;
  const Tensor off = batch.weighted_tilt - batch.weight * at_points.tilts;
  const Tensor pull = (at_points.slopes * off.unsqueeze(2)).sum(1) -
                      precision.matmul((at_points.parameters - mean).unsqueeze(2)).squeeze(2);
  const Tensor covariance = at::linalg_inv(information);
  const Tensor step = covariance.matmul(pull.unsqueeze(2)).squeeze(2);
  return {at_points.parameters + (step - step.detach()), covariance};
}

Tensor variances(const Tensor& rows) {
  return rows.narrow(1, output_count, output_count * output_count)
      .view({-1, output_count, output_count})
      .diagonal(0, 1, 2);
}

}  // namespace

std::vector<FrameEvidence> frame_evidence(const NetworkOutput& output, std::span<const BatchImage> images,
                                          const ModelCard& card) {
  return frames_of(batch_evidence(output, images, card), images, card);
}

Tensor head_rows(const NetworkOutput& output, std::span<const BatchImage> images, const ModelCard& card) {
  if (!is_fit(card.options.head)) return output.numbers;
  const BatchEvidence batch = batch_evidence(output, images, card);
  const std::vector<FrameEvidence> frames = frames_of(batch, images, card);
  const auto [parameters, covariance] = last_step(batch, fitted_points(frames, card.targets));
  const Tensor of_outputs = covariance.narrow(1, 0, output_count).narrow(2, 0, output_count);
  return at::cat({parameters.narrow(1, 0, output_count), of_outputs.flatten(1)}, 1).to(torch::kFloat);
}

LensPosterior posterior_of(std::span<const float> row, const ModelCard& card) {
  LensPosterior posterior;
  const Standardisation& by = card.targets;
  for (int i = 0; i < output_count; ++i) {
    posterior.mean[i] = by.mean[i] + by.deviation[i] * row[i];
    for (int k = 0; k < output_count; ++k)
      posterior.covariance(i, k) = row[output_count + i * output_count + k] * by.deviation[i] *
                                   by.deviation[k] * card.deviation_scale[i] * card.deviation_scale[k];
  }
  double& hfov_rad = posterior.mean[0];
  hfov_rad = std::clamp(hfov_rad, fitted_hfov_rad.low, fitted_hfov_rad.high);
  return posterior;
}

Tensor likelihood_loss(const Tensor& rows, const Tensor& truth) {
  const Tensor variance = variances(rows).clamp_min(1e-6);
  const Tensor error = rows.narrow(1, 0, output_count) - truth.to(rows.device());
  return .5 * (error.square() / variance + variance.log()).mean();
}

Tensor folding_penalty(const Tensor& rows, std::span<const Outputs> truth, const Standardisation& by) {
  constexpr int radii = 8;
  constexpr double least_slope = .15;
  Tensor squares = torch::empty({static_cast<long>(truth.size()), radii});
  float* out = squares.data_ptr<float>();
  for (const Outputs& outputs : truth) {
    const double corner = ideal_radius(outputs, 1).radius;
    for (int i = 1; i <= radii; ++i) *out++ = static_cast<float>(std::pow(corner * i / radii, 2));
  }
  const Tensor s = squares.to(rows.device());
  const auto coefficient = [&](int i) { return rows.narrow(1, i, 1) * by.deviation[i] + by.mean[i]; };
  const Tensor slope = 1 + s * (3 * coefficient(1) + s * (5 * coefficient(2) + s * 7 * coefficient(3)));
  return (least_slope - slope).relu().square().mean();
}

Outputs deviation_scale(const Tensor& rows, std::span<const Outputs> truth, const Standardisation& by) {
  Outputs scale;
  scale.fill(1);
  if (truth.empty()) return scale;
  constexpr double share = .6827;  // of a normal distribution, within one standard deviation
  const auto numbers = rows.accessor<float, 2>();
  for (int k = 0; k < output_count; ++k) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto row = numbers[static_cast<long>(i)];
      const double variance = row[output_count + k * (output_count + 1)];
      ratios.push_back(std::abs(row[k] - standardise(truth[i], by)[k]) /
                       std::sqrt(std::max(1e-12, variance)));
    }
    const auto middle = ratios.begin() + static_cast<long>(share * static_cast<double>(ratios.size() - 1));
    std::ranges::nth_element(ratios, middle);
    scale[k] = std::max(1e-3, *middle);
  }
  return scale;
}

}  // namespace cps
