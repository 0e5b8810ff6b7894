#include "distortion/panorama/panorama_warp.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "distortion/models/straight_angle.h"
#include "distortion/models/warp/ray_tile.h"
#include "distortion/panorama/spherical_gather.h"
#include "distortion/warp/tiles.h"
#include "distortion/warp/warp_checks.h"

namespace cps {
namespace {

constexpr int most_channels = 4;

/// One worker thread's buffers and tallies.
struct Worker {
  std::unique_ptr<RayTile> rays = std::make_unique_for_overwrite<RayTile>();
  std::array<float, RayTile::side * most_channels> pixels;
  double worst_residual_px = 0, smallest_variance = std::numeric_limits<double>::infinity();
  std::int64_t uncovered = 0;
};

/// Gathers the tile of the output whose rays are in `worker`.
void gather_tile(const SphericalPicture& picture, const Eigen::Matrix3d& panorama_from_camera,
                 double sigma_px, const TileRect& rect, Worker& worker, OIIO::ImageBuf& output) {
  const OIIO::ImageSpec& spec = output.spec();
  const int channels = spec.nchannels;
  for (int row = 0; row < rect.height; ++row) {
    worker.pixels.fill(0);
    for (int i = 0; i < rect.width; ++i) {
      const int index = row * RayTile::side + i;
      if (!worker.rays->is_seen(index)) {
        ++worker.uncovered;
        continue;
      }
      const SphericalFootprint footprint =
          spherical_footprint(picture.size(), panorama_from_camera * worker.rays->ray(index),
                              panorama_from_camera * worker.rays->jacobian(index), sigma_px);
      if (!(footprint.reach_rad <= widest_reach_rad)) {
        ++worker.uncovered;
        continue;
      }
      worker.smallest_variance = std::min(worker.smallest_variance, footprint.kernel.smaller_variance);
      picture.gather(footprint, &worker.pixels[i * channels]);
    }
    OIIO::convert_pixel_values(OIIO::TypeFloat, worker.pixels.data(), spec.format,
                               output.pixeladdr(rect.x0, rect.y0 + row), rect.width * channels);
  }
}

}  // namespace

Eigen::Matrix3d panorama_from_camera(double yaw_rad, double pitch_rad, double roll_rad) {
  const SineCosine yaw = straight_sine_cosine(yaw_rad), pitch = straight_sine_cosine(pitch_rad),
                   roll = straight_sine_cosine(roll_rad);
  Eigen::Matrix3d about_y, about_x, about_z;
  about_y << yaw.cosine, 0, yaw.sine, 0, 1, 0, -yaw.sine, 0, yaw.cosine;
  about_x << 1, 0, 0, 0, pitch.cosine, -pitch.sine, 0, pitch.sine, pitch.cosine;
  about_z << roll.cosine, -roll.sine, 0, roll.sine, roll.cosine, 0, 0, 0, 1;
  return about_y * about_x * about_z;
}

OIIO::ImageBuf photograph_panorama(const OIIO::ImageBuf& panorama,
                                   const Eigen::Matrix3d& panorama_from_camera, const ModelCamera& camera,
                                   const WarpOptions& options, WarpSummary* summary) {
  const OIIO::ImageSpec& source = panorama.spec();
  check_source(panorama, {.width = source.width, .height = source.height}, camera.pinhole, options);
  if (source.width != 2 * source.height)
    throw std::runtime_error(
        fmt::format("warp: the panorama is {} x {}: an equirectangular one is twice as wide as high",
                    source.width, source.height));
  if (options.resampling != Resampling::footprint)
    throw std::runtime_error("warp: a panorama can only be averaged: resampling = footprint");
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (!proof.valid) throw std::runtime_error("warp: " + proof.why);

  const ProvedCamera proved{camera, proof.region};
  const SphericalPicture picture(panorama);
  OIIO::ImageSpec spec(camera.pinhole.width, camera.pinhole.height, source.nchannels, source.format);
  spec.channelnames = source.channelnames;
  OIIO::ImageBuf image(spec, OIIO::InitializePixels::No);
  tbb::enumerable_thread_specific<Worker> workers;
  for_each_tile(spec.width, spec.height, [&](const TileRect& rect) {
    Worker& worker = workers.local();
    unproject_tile(proved, rect, *worker.rays);
    worker.worst_residual_px = std::max(worker.worst_residual_px, worker.rays->worst_residual_px);
    gather_tile(picture, panorama_from_camera, options.kernel_sigma_px, rect, worker, image);
  });

  WarpSummary result;
  double smallest_variance = std::numeric_limits<double>::infinity();
  for (const Worker& worker : workers) {
    result.worst_residual_px = std::max(result.worst_residual_px, worker.worst_residual_px);
    result.uncovered_pixels += worker.uncovered;
    smallest_variance = std::min(smallest_variance, worker.smallest_variance);
  }
  result.smallest_kernel_sigma_px = std::sqrt(std::max(0.0, smallest_variance));
  if (summary) *summary = result;
  check_summary(result, options);
  return image;
}

}  // namespace cps
