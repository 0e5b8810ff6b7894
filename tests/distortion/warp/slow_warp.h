#pragma once

#include <OpenImageIO/imagebuf.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "distortion/inverse/inverse.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/noise_kernels.h"

/// The warp of docs/lens.md by the book: matrices instead of conics, one pixel at a time, everything in
/// double precision.
namespace cps {

/// Sets pixel i of a row to the kernel of this covariance, as footprints.h keeps it.
inline void set_kernel(KernelRow& row, int i, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d conic = covariance.inverse() / (kernel_support * kernel_support);
  row.conic_xx[i] = float(conic(0, 0));
  row.conic_xy[i] = float(conic(0, 1));
  row.conic_yy[i] = float(conic(1, 1));
  row.half_width[i] = float(kernel_support * std::sqrt(covariance(0, 0)));
  row.half_height[i] = float(kernel_support * std::sqrt(covariance(1, 1)));
}

using Channels = std::array<double, 4>;

/// The mean of the image's pixels about `centre`, weighted with the kernel of this covariance.
inline Channels slow_gather(const OIIO::ImageBuf& image, const Eigen::Vector2d& centre,
                            const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d inverse = covariance.inverse();
  const Eigen::Vector2d reach = kernel_support * covariance.diagonal().cwiseSqrt();
  Channels sums{};
  double weights = 0;
  for (int y = int(std::ceil(centre.y() - reach.y())); y <= centre.y() + reach.y(); ++y)
    for (int x = int(std::ceil(centre.x() - reach.x())); x <= centre.x() + reach.x(); ++x) {
      const Eigen::Vector2d offset = Eigen::Vector2d(x, y) - centre;
      const double weight =
          std::pow(std::max(0.0, 1 - offset.dot(inverse * offset) / (kernel_support * kernel_support)), 3);
      weights += weight;
      for (int c = 0; c < image.nchannels(); ++c) sums[c] += weight * image.getchannel(x, y, 0, c);
    }
  for (double& sum : sums) sum /= weights;
  return sums;
}

/// The kernel of the noise to add behind a picture's kernel, and its weight.
struct SlowNoiseKernel {
  Eigen::Matrix2d covariance;
  double weight;
};

inline SlowNoiseKernel slow_noise_kernel(const Eigen::Matrix2d& picture, double sigma_px) {
  const auto correlation_of = [](double variance) { return std::exp(-0.25 / variance); };
  const double grain_variance = sigma_px * sigma_px - noise_grain_px * noise_grain_px / 12;
  const double wanted_level = noise_grain_px * noise_grain_px / grain_variance;
  const double wanted_correlation = correlation_of(grain_variance);

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(picture);
  // Sides of a source pixel along the axes, and variances of the picture's kernel, output pixels.
  Eigen::Vector2d side, variance, added;
  for (int i = 0; i < 2; ++i) {
    side[i] = sigma_px / std::sqrt(axes.eigenvalues()[i] + 1.0 / 12);
    variance[i] = sigma_px * sigma_px - side[i] * side[i] / 12;
  }
  const double share = side.prod() / std::sqrt(variance.prod()) / wanted_level;
  if (share >= 1) return {picture, 0};
  for (int i = 0; i < 2; ++i) {
    const double correlation = (wanted_correlation - share * correlation_of(variance[i])) / (1 - share);
    const double ideal = -0.25 / std::log(std::min(std::max(correlation, 0.05), 0.9));
    added[i] = std::min(std::max(ideal, 0.1), variance[i]);
  }
  const double level = side.prod() / std::sqrt(added.prod());
  const Eigen::Vector2d in_source = added.array() / side.array().square();
  return {axes.eigenvectors() * in_source.asDiagonal() * axes.eigenvectors().transpose(),
          std::sqrt((1 - share) * wanted_level / level)};
}

/// The covariance of an output pixel's kernel, source pixels; Jacobian: ∂source px/∂output px.
inline Eigen::Matrix2d slow_covariance(const Eigen::Matrix2d& jacobian, double sigma_px) {
  const Eigen::Matrix2d covariance =
      sigma_px * sigma_px * jacobian * jacobian.transpose() - Eigen::Matrix2d::Identity() / 12;
  const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues().minCoeff();
  const double lacking = std::max(0.0, narrowest_sigma_px * narrowest_sigma_px - smallest);
  return covariance + lacking * Eigen::Matrix2d::Identity();
}

/// One pixel of the warp of a picture with render noise made even.
inline Channels slow_warp_pixel(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& noise,
                                const Pinhole& master, const Distortion& lens, const Eigen::AlignedBox2d& box,
                                const Pinhole& output, double sigma_px, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d ideal = undistort(lens, box, to_plane(output, pixel)).value();
  const Eigen::Matrix2d jacobian = Eigen::Vector2d(master.fx, master.fy).asDiagonal() *
                                   distortion_jacobian(lens, ideal).inverse() *
                                   Eigen::Vector2d(1 / output.fx, 1 / output.fy).asDiagonal();
  const Eigen::Vector2d centre = to_pixel(master, ideal);
  const Eigen::Matrix2d covariance = slow_covariance(jacobian, sigma_px);
  const SlowNoiseKernel kernel = slow_noise_kernel(covariance, sigma_px);
  Channels sum = slow_gather(picture, centre, covariance);
  if (kernel.weight == 0) return sum;
  const Channels added = slow_gather(noise, centre, kernel.covariance);
  for (int c = 0; c < 4; ++c) sum[c] += kernel.weight * added[c];
  return sum;
}

}  // namespace cps
