#include <algorithm>
#include <cmath>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/certificate/rational_certificate.h"
#include "distortion/models/certificate/rays_of_proof.h"
#include "distortion/models/straight_angle.h"

namespace cps {
namespace {

/// The largest square about the principal point, with sides at `max_radius` or less, on which a lens of a
/// plane is certified.
template <typename Lens>
Eigen::AlignedBox2d largest_square(const Lens& lens, double max_radius) {
  const auto square = [](double half) {
    return Eigen::AlignedBox2d(Eigen::Vector2d::Constant(-half), Eigen::Vector2d::Constant(half));
  };
  double certified = 0, refused_at = max_radius;
  if (is_certified(lens, square(refused_at), one_to_one)) return square(refused_at);
  while (refused_at - certified > 1e-9 * refused_at) {
    const double middle = 0.5 * (certified + refused_at);
    (is_certified(lens, square(middle), one_to_one) ? certified : refused_at) = middle;
  }
  return square(certified);
}

struct OnLargestRegion {
  double max_radius;

  template <typename Lens>
  ModelCertificate on_largest_square(const Lens& lens) const {
    const Eigen::AlignedBox2d box = largest_square(lens, max_radius);
    return on_plane(certify(lens, box, one_to_one), box);
  }
  ModelCertificate operator()(const Distortion& lens) const { return on_largest_square(lens); }
  ModelCertificate operator()(const RationalLens& lens) const { return on_largest_square(lens); }
  ModelCertificate operator()(const UnifiedSpherical& lens) const {
    const SphereReach reach = sphere_reach(lens.xi);
    const Eigen::AlignedBox2d box = largest_square(lens.distortion, std::min(max_radius, reach.max_radius));
    return on_sphere(lens.xi, reach, certify(lens.distortion, box, one_to_one), box);
  }
  template <typename Lens>
  ModelCertificate operator()(const Lens& lens) const {
    return on_cone(lens, largest_growing_angle(lens));
  }
};

ModelCertificate refused(const std::string& why) {
  ModelCertificate result;
  result.why = why;
  return result;
}

}  // namespace

bool contains(const RayRegion& region, const LensModel& lens, const Eigen::Vector3d& ray) {
  const double across = ray.head<2>().norm();
  if (!(angle_from_axis(across, ray.z()).angle_rad <= region.max_angle_rad)) return false;
  if (!region.box) return true;
  const auto* unified = std::get_if<UnifiedSpherical>(&lens);
  const double along = unified ? ray.z() + unified->xi * ray.norm() : ray.z();
  return along > 0 && region.box->contains(Eigen::Vector2d(ray.head<2>() / along));
}

ModelCertificate certify_region(const LensModel& lens, double max_radius) {
  if (const std::string why = fault(lens); !why.empty()) return refused(why);
  if (!(max_radius > 0 && std::isfinite(max_radius)))
    return refused("max_radius: must be positive and finite");
  return std::visit(OnLargestRegion{max_radius}, lens);
}

}  // namespace cps
