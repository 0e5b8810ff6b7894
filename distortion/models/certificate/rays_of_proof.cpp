#include "distortion/models/certificate/rays_of_proof.h"

#include <algorithm>

#include "distortion/models/straight_angle.h"

namespace cps {
namespace {

/// The cone to a corner must contain the corner, however its angle is rounded.
double with_rounding(double angle_rad) {
  return angle_rad * (1 + 1e-14);
}

ModelCertificate on_box(const Certificate& proof, const Eigen::AlignedBox2d& box) {
  ModelCertificate result;
  result.valid = proof.valid;
  result.region.box = box;
  result.min_scale = proof.min_eigenvalue;
  result.max_scale = proof.max_eigenvalue;
  result.why = proof.why;
  return result;
}

}  // namespace

double farthest_radius(const Eigen::AlignedBox2d& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

ModelCertificate on_plane(const Certificate& proof, const Eigen::AlignedBox2d& box) {
  ModelCertificate result = on_box(proof, box);
  result.region.max_angle_rad = with_rounding(angle_from_axis(farthest_radius(box), 1).angle_rad);
  result.witness_angle_rad = angle_from_axis(proof.witness_radius, 1).angle_rad;
  return result;
}

ModelCertificate on_sphere(double xi, const SphereReach& reach, const Certificate& proof,
                           const Eigen::AlignedBox2d& box) {
  ModelCertificate result = on_box(proof, box);
  const double corner = farthest_radius(box);
  result.region.max_angle_rad = reach.max_angle_rad;
  if (corner < reach.max_radius)
    result.region.max_angle_rad =
        std::min(result.region.max_angle_rad, with_rounding(angle_on_sphere(xi, corner)));
  result.witness_angle_rad = angle_on_sphere(xi, std::min(proof.witness_radius, reach.max_radius));
  return result;
}

}  // namespace cps
