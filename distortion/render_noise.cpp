#include "distortion/render_noise.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cps {
namespace {

namespace algo = OIIO::ImageBufAlgo;

/// White noise through a normal kernel of variance c along an axis has values one pixel apart correlated by
/// exp(−1/4c); what is left of its variance is proportional to 1/√c per axis.
double correlation_of(double variance) {
  return std::exp(-0.25 / variance);
}
double variance_of(double correlation) {
  return -0.25 / std::log(correlation);
}

/// Kernels of the picture → kernels and weights of the noise to be added. Along each principal axis of a
/// footprint, picture and addition together have the correlation of neighbours that the wanted grain has, and
/// over both axes its variance.
void turn_into_noise_kernels(FootprintTile& tile, double sigma_px) {
  constexpr double pixel_variance = 1.0 / 12, support2 = kernel_support * kernel_support;
  constexpr double grain_area = noise_grain_px * noise_grain_px;
  const double sigma2 = sigma_px * sigma_px;
  const double wanted_variance = sigma2 - grain_area * pixel_variance;
  const double wanted_level = grain_area / wanted_variance,
               wanted_correlation = correlation_of(wanted_variance);
  tile.weighted = true;
  for (int row = 0; row < tile.height; ++row)
    for (int column = 0; column < tile.width; ++column) {
      const int index = row * FootprintTile::side + column;
      // Eigenvalues of the picture's conic, and the axis of the first.
      const double xx = tile.conic_xx[index], xy = tile.conic_xy[index], yy = tile.conic_yy[index];
      const double middle = 0.5 * (xx + yy), half_difference = 0.5 * (xx - yy);
      const double reach = std::sqrt(half_difference * half_difference + xy * xy);
      const double cos2 = reach > 0 ? half_difference / reach : 1, sin2 = reach > 0 ? xy / reach : 0;
      double source_area[2],
          variance[2];  // of the picture's kernel along the axes: (source px)² and output px
      for (int axis = 0; axis < 2; ++axis) {
        const double kernel = 1 / (support2 * (axis == 0 ? middle + reach : middle - reach));
        source_area[axis] = (kernel + pixel_variance) / sigma2;
        variance[axis] = kernel / source_area[axis];
      }
      const double area = 1 / std::sqrt(source_area[0] * source_area[1]);  // of a master pixel, output px²
      const double share = area / std::sqrt(variance[0] * variance[1]) / wanted_level;
      if (!(share < 1)) {
        tile.weight[index] = 0;
        continue;
      }
      double conic[2], added_variance[2];
      for (int axis = 0; axis < 2; ++axis) {
        const double correlation =
            (wanted_correlation - share * correlation_of(variance[axis])) / (1 - share);
        // Next to share 1 little is added, and no kernel makes up for what an uneven footprint lacks.
        added_variance[axis] =
            std::clamp(variance_of(std::clamp(correlation, 0.05, 0.9)), 0.1, variance[axis]);
        conic[axis] = 1 / (support2 * source_area[axis] * added_variance[axis]);
      }
      const double level = area / std::sqrt(added_variance[0] * added_variance[1]);
      tile.weight[index] = static_cast<float>(std::sqrt((1 - share) * wanted_level / level));
      const double mean = 0.5 * (conic[0] + conic[1]), difference = 0.5 * (conic[0] - conic[1]);
      const double new_xx = mean + difference * cos2, new_yy = mean - difference * cos2,
                   new_xy = difference * sin2, determinant = conic[0] * conic[1];
      tile.conic_xx[index] = static_cast<float>(new_xx);
      tile.conic_xy[index] = static_cast<float>(new_xy);
      tile.conic_yy[index] = static_cast<float>(new_yy);
      tile.half_width[index] = static_cast<float>(std::sqrt(new_yy / determinant));
      tile.half_height[index] = static_cast<float>(std::sqrt(new_xx / determinant));
    }
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
  WarpOptions unasked = options;
  unasked.require_resolution = false;  // asked of the picture already; no noise is added where it is lacking
  const OIIO::ImageBuf noise =
      warp_through([&](FootprintTile& tile) { turn_into_noise_kernels(tile, options.kernel_sigma_px); },
                   master.noise, master_camera, lens, output, unasked);
  algo::add(image, image, noise);
  return image;
}

}  // namespace cps
