#include "trainer/calibration/ray_truth.h"

#include <numbers>
#include <utility>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/warp/proved_camera.h"
#include "distortion/models/warp/seen_hfov.h"

namespace cps {

std::shared_ptr<const RayTruth> ray_truth(const CalibratedCamera& camera, const RayGrid& grid,
                                          const Eigen::AlignedBox2d& shape) {
  RayTruth truth{
      .camera = model_camera(camera), .pixels = grid.pixels, .rays = {}, .seen_hfov_rad = std::nullopt};
  for (const Eigen::Vector2d& ideal : grid.ideal) truth.rays.push_back(ideal.homogeneous().normalized());
  const RayRegion region{
      .max_angle_rad = std::numbers::pi / 2,
      .box = certify_frame(camera.distortion, camera.pinhole, shape, one_to_one).rectangle};
  truth.seen_hfov_rad = seen_hfov_rad(truth.camera, region);
  return std::make_shared<const RayTruth>(std::move(truth));
}

std::shared_ptr<const RayTruth> ray_truth(const ModelCamera& camera, int columns) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens)) {
    const CalibratedCamera plane{camera.name, camera.pinhole, *lens};
    const std::optional<RayGrid> grid = ray_grid(plane, columns);
    return grid ? ray_truth(plane, *grid, frame_on_plane(plane.pinhole)) : nullptr;
  }
  const RayRegion region = certify_frame(camera).region;
  if (is_empty(region)) return nullptr;
  RayTruth truth{.camera = camera, .pixels = {}, .rays = {}, .seen_hfov_rad = seen_hfov_rad(camera, region)};
  const std::vector<Eigen::Vector2d> pixels = pixel_grid(camera.pinhole, columns);
  for (const Eigen::Vector2d& pixel : pixels)
    if (const auto ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel))) {
      truth.pixels.push_back(pixel);
      truth.rays.push_back(*ray);
    }
  if (2 * truth.pixels.size() < pixels.size()) return nullptr;
  return std::make_shared<const RayTruth>(std::move(truth));
}

}  // namespace cps
