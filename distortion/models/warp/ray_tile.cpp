#include "distortion/models/warp/ray_tile.h"

#include <algorithm>
#include <limits>

#include "distortion/inverse/inverse_map.h"
#include "distortion/models/inverse/region_inverse.h"
#include "distortion/models/projected_ray.h"
#include "distortion/models/projection.h"

namespace cps {

void RayTile::set(int index, const Eigen::Vector3d& ray, const Eigen::Matrix<double, 3, 2>& jacobian) {
  x[index] = ray.x(), y[index] = ray.y(), z[index] = ray.z();
  xu[index] = jacobian(0, 0), yu[index] = jacobian(1, 0), zu[index] = jacobian(2, 0);
  xv[index] = jacobian(0, 1), yv[index] = jacobian(1, 1), zv[index] = jacobian(2, 1);
}

void RayTile::set_unseen(int index) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  set(index, Eigen::Vector3d::Constant(none), Eigen::Matrix<double, 3, 2>::Constant(none));
}

namespace {

constexpr int side = RayTile::side;

/// ∂ray/∂(column, row) from ∂ray/∂point.
Eigen::Matrix<double, 3, 2> per_pixel(const Eigen::Matrix<double, 3, 2>& per_point, const Pinhole& pinhole) {
  return per_point * Eigen::Vector2d(1 / pinhole.fx, 1 / pinhole.fy).asDiagonal();
}

/// Any family, pixel by pixel.
template <typename Lens>
void unproject_pixels(const Lens& lens, const RayRegion& region, const Pinhole& pinhole, const TileRect& rect,
                      RayTile& tile) {
  const RegionInverse<Lens> inverse(lens, region);
  double worst = 0;
  for (int row = 0; row < rect.height; ++row)
    for (int i = 0; i < rect.width; ++i) {
      const int index = row * side + i;
      const Eigen::Vector2d point = to_plane(pinhole, {rect.x0 + i, rect.y0 + row});
      const std::optional<Eigen::Vector3d> ray = inverse(point);
      if (!ray) {
        tile.set_unseen(index);
        continue;
      }
      const ProjectedRay back = project(lens, *ray);
      tile.set(index, *ray, per_pixel(ray_jacobian(back.jacobian), pinhole));
      worst = std::max(worst, (back.point - point).norm());
    }
  tile.worst_residual_px = worst * std::max(pinhole.fx, pinhole.fy);
}

/// Brown–Conrady, many pixels at once. Unchecked: the region has a box.
void unproject_pixels(const Distortion& lens, const RayRegion& region, const Pinhole& pinhole,
                      const TileRect& rect, RayTile& tile) {
  InverseMapTile ideal;
  invert_tile(lens, *region.box, pinhole, rect, ideal);
  tile.worst_residual_px = ideal.worst_residual_px;
  for (int row = 0; row < rect.height; ++row)
    for (int i = 0; i < rect.width; ++i) {
      const int index = row * side + i;
      const Eigen::Vector2d at(ideal.x[index], ideal.y[index]);
      const Eigen::Vector3d ray = at.homogeneous().normalized();
      // A unit ray moves with the ideal point as the part of (dx, dy, 0) · z across itself.
      const Eigen::Matrix<double, 3, 2> per_ideal =
          ray.z() * (Eigen::Matrix3d::Identity() - ray * ray.transpose()).leftCols<2>();
      tile.set(index, ray, per_pixel(per_ideal * distortion_jacobian(lens, at).inverse(), pinhole));
    }
}

}  // namespace

void unproject_tile(const ProvedCamera& camera, const TileRect& rect, RayTile& tile) {
  tile.width = rect.width;
  tile.height = rect.height;
  std::visit(
      [&](const auto& lens) { unproject_pixels(lens, camera.region, camera.camera.pinhole, rect, tile); },
      camera.camera.lens);
}

}  // namespace cps
