#include "distortion/warp/render_noise.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cps {
namespace {

namespace algo = OIIO::ImageBufAlgo;

constexpr double pixel_variance = 1.0 / 12, support2 = kernel_support * kernel_support;

/// White noise filtered by a Gaussian of variance c along an axis: values one pixel apart have correlation
/// exp(−1/4c), and the remaining variance is proportional to 1/√c per axis.
double correlation_of(double variance) {
  return std::exp(-0.25 / variance);
}
double variance_of(double correlation) {
  return -0.25 / std::log(correlation);
}

/// Level and correlation of neighbouring pixels of the noise that master pixels of noise_grain_px would
/// leave.
struct Grain {
  double level, correlation;
};

Grain wanted_grain(double sigma2) {
  constexpr double area = noise_grain_px * noise_grain_px;
  const double variance = sigma2 - area * pixel_variance;
  return {.level = area / variance, .correlation = correlation_of(variance)};
}

/// A conic's eigenvalues, and cosine and sine of twice the angle of the first one's axis.
struct PrincipalAxes {
  double eigenvalue[2], cos2, sin2;
};

PrincipalAxes principal_axes(double xx, double xy, double yy) {
  const double middle = 0.5 * (xx + yy), half_difference = 0.5 * (xx - yy);
  const double reach = std::sqrt(half_difference * half_difference + xy * xy);
  return {.eigenvalue = {middle + reach, middle - reach},
          .cos2 = reach > 0 ? half_difference / reach : 1,
          .sin2 = reach > 0 ? xy / reach : 0};
}

void set_conic(FootprintTile& tile, int index, const PrincipalAxes& axes) {
  const auto& [first, second] = axes.eigenvalue;
  const double mean = 0.5 * (first + second), difference = 0.5 * (first - second);
  const double xx = mean + difference * axes.cos2, yy = mean - difference * axes.cos2,
               xy = difference * axes.sin2, determinant = first * second;
  tile.conic_xx[index] = static_cast<float>(xx);
  tile.conic_xy[index] = static_cast<float>(xy);
  tile.conic_yy[index] = static_cast<float>(yy);
  tile.half_width[index] = static_cast<float>(std::sqrt(yy / determinant));
  tile.half_height[index] = static_cast<float>(std::sqrt(xx / determinant));
}

/// Replaces the kernel of the picture by kernel and weight of the noise to add, chosen so that picture and
/// added noise together have the wanted correlation of neighbours along each principal axis of the footprint,
/// and the wanted level.
void turn_into_noise_kernel(FootprintTile& tile, int index, double sigma2, const Grain& wanted) {
  PrincipalAxes axes = principal_axes(tile.conic_xx[index], tile.conic_xy[index], tile.conic_yy[index]);
  double source_area[2], variance[2];  // of the picture's kernel along the axes: (source px)² and output px
  for (int axis = 0; axis < 2; ++axis) {
    const double kernel = 1 / (support2 * axes.eigenvalue[axis]);
    source_area[axis] = (kernel + pixel_variance) / sigma2;
    variance[axis] = kernel / source_area[axis];
  }
  const double area = 1 / std::sqrt(source_area[0] * source_area[1]);  // of a master pixel, output px²
  const double share = area / std::sqrt(variance[0] * variance[1]) / wanted.level;
  if (!(share < 1)) {
    tile.weight[index] = 0;
    return;
  }
  double added_variance[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double correlation = (wanted.correlation - share * correlation_of(variance[axis])) / (1 - share);
    // Near share 1 little noise is added, and no kernel can give an elongated footprint the wanted
    // correlation.
    added_variance[axis] = std::clamp(variance_of(std::clamp(correlation, 0.05, 0.9)), 0.1, variance[axis]);
    axes.eigenvalue[axis] = 1 / (support2 * source_area[axis] * added_variance[axis]);
  }
  const double level = area / std::sqrt(added_variance[0] * added_variance[1]);
  tile.weight[index] = static_cast<float>(std::sqrt((1 - share) * wanted.level / level));
  set_conic(tile, index, axes);
}

void turn_into_noise_kernels(FootprintTile& tile, double sigma_px) {
  const double sigma2 = sigma_px * sigma_px;
  const Grain wanted = wanted_grain(sigma2);
  tile.weighted = true;
  for (int row = 0; row < tile.height; ++row)
    for (int column = 0; column < tile.width; ++column)
      turn_into_noise_kernel(tile, row * FootprintTile::side + column, sigma2, wanted);
}

}  // namespace

NoisyMaster join_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second) {
  const OIIO::ImageSpec &a = first.spec(), &b = second.spec();
  if (a.width != b.width || a.height != b.height || a.nchannels != b.nchannels || a.format != b.format)
    throw std::runtime_error("the master's halves differ in size, channels or pixel type");
  NoisyMaster master{.picture = algo::add(first, second), .noise = algo::sub(first, second)};
  algo::mul(master.picture, master.picture, 0.5f);
  algo::mul(master.noise, master.noise, 0.5f);
  return master;
}

OIIO::ImageBuf warp(const NoisyMaster& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  if (options.resampling != Resampling::footprint)
    throw std::runtime_error("warp: a noisy master can only be averaged: resampling = footprint");
  OIIO::ImageBuf image = warp(master.picture, master_camera, lens, output, options, summary);
  WarpOptions noise_options = options;
  noise_options.require_resolution = false;  // checked above; where it is lacking, no noise is added
  const OIIO::ImageBuf noise =
      warp_through([&](FootprintTile& tile) { turn_into_noise_kernels(tile, options.kernel_sigma_px); },
                   master.noise, master_camera, lens, output, noise_options);
  algo::add(image, image, noise);
  return image;
}

}  // namespace cps
