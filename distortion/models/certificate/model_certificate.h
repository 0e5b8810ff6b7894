#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "distortion/certificate/certificate.h"
#include "distortion/models/model_camera.h"

namespace cps {

/// Rays on which a lens is proved one-to-one: the cone of `max_angle_rad` about the axis and, for families
/// with a map on a plane (brown_conrady, rational: the plane z = 1; unified_spherical: that of
/// (x, y) / (z + ξ)), inside it the rays that meet the rectangle `box` of that plane. Their cone reaches to
/// the box' farthest corner, or as far as rays land on the plane.
struct RayRegion {
  double max_angle_rad = 0;
  std::optional<Eigen::AlignedBox2d> box = {};
};

/// Whether the region contains a ray (camera frame, any positive length) of a lens of its family.
bool contains(const RayRegion& region, const LensModel& lens, const Eigen::Vector3d& ray);

/// Proof, or refutation, that a camera's lens maps a region one-to-one onto a part of the normalised image
/// that contains the whole frame.
struct ModelCertificate {
  bool valid = false;
  RayRegion region;  ///< if there is no proof for the frame, the largest region that is proved
  /// Enclose the local scale of the family's map on the region: the eigenvalues of the plane map's Jacobian,
  /// or, for radially symmetric families, dr/dθ.
  double min_scale = 0, max_scale = 0;
  double witness_angle_rad = 0;  ///< where the smallest scale is attained
  std::string why;               ///< of a refusal, one line; empty when valid
};

/// The camera's lens on its frame. Brown–Conrady: certify_frame(). Radially symmetric families are proved in
/// one dimension: dr/dθ is positive up to the angle that the frame's farthest corner sees; for kannala_brandt
/// by Bernstein bounds in θ², for the others in closed form, rounding included. The rational family: as
/// Brown–Conrady, with bounds on numerator and denominator apart. unified_spherical: its closed form on the
/// sphere, then Brown–Conrady's certificate on the rectangle of the intermediate plane; the part of it whose
/// image the frame needs must lie where rays land. Uses `options` for families with a map on a plane; the
/// others require a slope above 1e-6. Refuses unusable cameras as certify_frame() does, and parameters out of
/// range; then the region is the axis only.
///
/// A frame with a corner that no ray reaches, as around a fisheye's image circle, is not valid: `region` is
/// all that the lens can show, and `why` names the corner. A picture of it can be used within the region.
ModelCertificate certify_frame(const ModelCamera& camera, const CertificateOptions& options = one_to_one);

/// The largest region on which the lens is proved at all, whatever the frame: up to angle_limit() (less 1e-9)
/// or where the map stops growing. Families with a map on a plane: the largest square about the principal
/// point with sides at `max_radius` or less. Valid if there is one; not for parameters out of range.
ModelCertificate certify_region(const LensModel& lens, double max_radius = 100);

}  // namespace cps
