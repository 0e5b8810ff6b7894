#include "distortion/models/warp/model_footprints.h"

#include <limits>
#include <memory>

#include "distortion/models/projection.h"
#include "distortion/models/warp/ray_tile.h"

namespace cps {
namespace {

constexpr int tile_side = FootprintTile::side;

/// Projects the rays of a tile into the source, a picture taken through `lens`.
template <typename Lens>
void project_tile(const Lens& lens, const ProvedCamera& source, const RayTile& rays, double sigma_px,
                  FootprintTile& tile) {
  const Pinhole& pinhole = source.camera.pinhole;
  const Eigen::Vector2d focal(pinhole.fx, pinhole.fy);
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  PixelJacobianRow jacobian;
  for (int row = 0; row < rays.height; ++row) {
    for (int i = 0; i < rays.width; ++i) {
      const int index = row * tile_side + i;
      const Eigen::Vector3d ray = rays.ray(index);
      Eigen::Vector2d centre = Eigen::Vector2d::Constant(nowhere);
      Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
      if (rays.is_seen(index) && contains(source.region, source.camera.lens, ray)) {
        const ProjectedRay at = project(lens, ray);
        centre = to_pixel(pinhole, at.point);
        a = focal.asDiagonal() * (at.jacobian * rays.jacobian(index));
      }
      tile.x[index] = centre.x();
      tile.y[index] = centre.y();
      jacobian.xx[i] = a(0, 0);
      jacobian.xy[i] = a(0, 1);
      jacobian.yx[i] = a(1, 0);
      jacobian.yy[i] = a(1, 1);
    }
    kernels_of_row(jacobian, sigma_px, row, tile);
  }
}

}  // namespace

void model_footprints(const ProvedCamera& source, const ProvedCamera& output, double sigma_px,
                      const TileRect& rect, FootprintTile& tile) {
  const auto rays = std::make_unique_for_overwrite<RayTile>();
  unproject_tile(output, rect, *rays);
  tile.width = rect.width;
  tile.height = rect.height;
  tile.worst_residual_px = rays->worst_residual_px;
  std::visit([&](const auto& lens) { project_tile(lens, source, *rays, sigma_px, tile); },
             source.camera.lens);
}

}  // namespace cps
