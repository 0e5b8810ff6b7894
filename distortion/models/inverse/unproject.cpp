#include "distortion/models/inverse/unproject.h"

#include "distortion/models/inverse/region_inverse.h"
#include "distortion/models/projection.h"

namespace cps {

std::optional<Eigen::Vector3d> unproject(const LensModel& lens, const RayRegion& region,
                                         const Eigen::Vector2d& point) {
  return std::visit([&](const auto& family) { return RegionInverse(family, region)(point); }, lens);
}

std::optional<UnprojectedPoint> unproject_with_jacobian(const LensModel& lens, const RayRegion& region,
                                                        const Eigen::Vector2d& point) {
  const auto ray = unproject(lens, region, point);
  if (!ray) return {};
  return UnprojectedPoint{*ray, ray_jacobian(project(lens, *ray).jacobian)};
}

}  // namespace cps
