#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/certificate/certificate.h"
#include "distortion/pinhole.h"

namespace cps {

struct CropOptions {
  double max_zoom = 3;
  /// Cap on zoom · largest eigenvalue, the factor by which the output enlarges the base at most. The default
  /// is what the default master is fine enough for, largest_magnification(WarpOptions{}).
  double max_magnification = 1.96;
  CertificateOptions certificate = {};

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// The final image of a lens: the largest frame about its principal point that shows no black border.
struct Crop {
  bool valid = false;
  double zoom = 1;                ///< ≥ 1: final focal length / base focal length
  Pinhole camera;                 ///< of the final image, base's size, the principal point asked for
  double worst_roundtrip_px = 0;  ///< of the frame's rim: largest |D(undistort(d)) − d|
  Certificate certificate;        ///< on the base frame
  std::string why;                ///< of a refusal, one line
};

/// Zoom of the border-free crop, without the checks that border_free_crop() makes: for searches. Requires a
/// lens certified on frame_on_plane(base) and a principal point inside the frame.
///
/// With N the gauge of the unzoomed frame about the principal point, the largest copy of the frame inside
/// D(B), B = frame_on_plane(base), is touched by the distorted rim of B: zoom = max(1, 1 / min over ∂B of
/// N(D(b))). No inverse is needed; the minimum is a proved bound (branch and bound, Bernstein).
double border_free_zoom(const Distortion& lens, const Pinhole& base,
                        const Eigen::Vector2d& principal_point_px);

/// The crop, checked: the area of every output pixel lies inside D(frame_on_plane(base)), as the inverse of
/// every pixel corner on the frame's rim confirms. `base` has the output's size, square pixels and a centred
/// principal point; `principal_point_px` is the final image's. Refuses (see `why`) unusable options, an
/// uncertified lens, a principal point outside the frame, and zoom or magnification above the caps.
Crop border_free_crop(const Distortion& lens, const Pinhole& base, const Eigen::Vector2d& principal_point_px,
                      const CropOptions& options = {});

/// The base from which the crop ends at a given final H-FOV. The coefficients are relative to the master
/// (`scaled`: k_i · R^2i, p_i · R with R the master's half diagonal on the plane z = 1), so the zoom does not
/// depend on the H-FOV, and the base follows in closed form: tan(base/2) = zoom · tan(final/2).
struct LabelFirst {
  Pinhole base;     ///< what to render
  Distortion lens;  ///< `scaled`, in the units of the plane z = 1 of that base
};
LabelFirst base_for_final_hfov(const Distortion& scaled, int width, int height, double final_hfov_rad,
                               const Eigen::Vector2d& principal_point_px);

}  // namespace cps
