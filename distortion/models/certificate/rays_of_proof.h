#pragma once

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/certificate/radial_certificate.h"
#include "distortion/models/certificate/sphere_reach.h"

/// Certificates of a family's map, stated for rays.
namespace cps {

/// The radius of the box' farthest corner.
double farthest_radius(const Eigen::AlignedBox2d& box);

/// Of a lens of the plane z = 1, certified on `box`.
ModelCertificate on_plane(const Certificate& proof, const Eigen::AlignedBox2d& box);

/// Of a unified lens whose Brown–Conrady part is certified on `box` of the sphere's plane.
ModelCertificate on_sphere(double xi, const SphereReach& reach, const Certificate& proof,
                           const Eigen::AlignedBox2d& box);

/// Of a radially symmetric lens on the cone of `max_angle_rad`.
template <typename Lens>
ModelCertificate on_cone(const Lens& lens, double max_angle_rad) {
  const RadialCertificate proof = certify_cone(lens, max_angle_rad);
  ModelCertificate result;
  result.valid = max_angle_rad > 0 && proof.slope.low > 0;
  result.region = {.max_angle_rad = max_angle_rad};
  result.min_scale = proof.slope.low;
  result.max_scale = proof.slope.high;
  result.witness_angle_rad = proof.witness_angle_rad;
  if (!result.valid) result.why = "the radius cannot be shown to grow with the angle from the axis";
  return result;
}

}  // namespace cps
