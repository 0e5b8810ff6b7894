#include "trainer/calibration/reprojection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"

namespace cps {

std::vector<Eigen::Vector2d> pixel_grid(const Pinhole& camera, int columns) {
  const int rows =
      std::max(2, static_cast<int>(std::lround(static_cast<double>(columns) * camera.height / camera.width)));
  std::vector<Eigen::Vector2d> pixels;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      pixels.emplace_back((c + .5) / columns * camera.width - .5, (r + .5) / rows * camera.height - .5);
  return pixels;
}

namespace {

/// The grid points inside the largest certified rectangle similar to `shape`. Empty if they are less than
/// `min_share` of the grid, or if any is missing although the lens is one-to-one in its frame.
std::optional<RayGrid> shown_grid(const CalibratedCamera& truth, const Eigen::AlignedBox2d& shape,
                                  int columns, double min_share) {
  const Pinhole& camera = truth.pinhole;
  const FrameCertificate frame = certify_frame(truth.distortion, camera, shape, one_to_one);
  const std::vector<Eigen::Vector2d> pixels = pixel_grid(camera, columns);
  RayGrid grid;
  for (const Eigen::Vector2d& pixel : pixels) {
    const auto ideal = undistort(truth.distortion, frame.rectangle, to_plane(camera, pixel));
    if (!ideal) continue;
    grid.pixels.push_back(pixel);
    grid.ideal.push_back(*ideal);
  }
  if (static_cast<double>(grid.pixels.size()) <
      (frame.valid() ? 1. : min_share) * static_cast<double>(pixels.size()))
    return std::nullopt;
  return grid;
}

}  // namespace

std::optional<RayGrid> ray_grid(const CalibratedCamera& truth, const Eigen::AlignedBox2d& shape,
                                int columns) {
  return shown_grid(truth, shape, columns, .9);
}

std::optional<RayGrid> ray_grid(const CalibratedCamera& truth, int columns) {
  return ray_grid(truth, frame_on_plane(truth.pinhole), columns);
}

std::shared_ptr<const RayGrid> loss_rays(const CalibratedCamera& truth, const Eigen::AlignedBox2d& shape,
                                         const std::string& label) {
  constexpr int columns = 12;
  std::optional<RayGrid> rays = shown_grid(truth, shape, columns, 1);
  if (!rays)
    throw std::runtime_error(label + ": the lens is not one-to-one in its frame: make this group again");
  return std::make_shared<const RayGrid>(std::move(*rays));
}

double reprojection_error_px(const RayGrid& truth, const CalibratedCamera& prediction) {
  double sum = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const Eigen::Vector2d predicted =
        to_pixel(prediction.pinhole, distort(prediction.distortion, truth.ideal[i]));
    sum += (predicted - truth.pixels[i]).norm();
  }
  return sum / static_cast<double>(truth.pixels.size());
}

std::optional<double> angular_error_deg(const RayGrid& truth, const CalibratedCamera& prediction) {
  const FrameCertificate frame = certify_frame(prediction.distortion, prediction.pinhole, one_to_one);
  if (!frame.valid()) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const auto ideal =
        undistort(prediction.distortion, frame.rectangle, to_plane(prediction.pinhole, truth.pixels[i]));
    if (!ideal) return std::nullopt;
    const Eigen::Vector3d a = truth.ideal[i].homogeneous(), b = ideal->homogeneous();
    sum += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return degrees(sum / static_cast<double>(truth.pixels.size()));
}

bool is_one_to_one(const CalibratedCamera& camera) {
  return certify_frame(camera.distortion, camera.pinhole, one_to_one).valid();
}

}  // namespace cps
