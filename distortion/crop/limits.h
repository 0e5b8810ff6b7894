#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/crop/crop.h"
#include "distortion/pinhole.h"
#include "numbers/interval.h"

namespace cps {

/// Which lenses may be drawn. Displacement and tangential coefficients are in units of the rectangle's half
/// diagonal, so they mean the same at every H-FOV. The defaults contain KITTI's cameras.
struct LensBounds {
  double min_eigenvalue = 0.15;  ///< of the Jacobian, see CertificateOptions
  double max_eigenvalue = 1.8;
  double max_displacement = 0.35;  ///< of any point, as a fraction of the half diagonal
  double max_tangential = 0.015;   ///< |(p1, p2)| · half diagonal

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// Whether the lens satisfies all bounds on the rectangle.
bool is_within(const LensBounds& bounds, const Distortion& lens, const Eigen::AlignedBox2d& rectangle);

enum class Coefficient { k1, k2, k3, p1, p2 };
inline constexpr Coefficient all_coefficients[] = {Coefficient::k1, Coefficient::k2, Coefficient::k3,
                                                   Coefficient::p1, Coefficient::p2};
double& coefficient(Distortion& lens, Coefficient which);
double coefficient(const Distortion& lens, Coefficient which);

/// The values of one coefficient, the others fixed, with which the lens is within the bounds. All bounds are
/// convex in the five coefficients, so this is one interval, every value inside it is allowed, and it
/// contains 0 whenever 0 is allowed. The ends are found by a bracketing root finder (TOMS 748: Alefeld,
/// Potra, Shi 1995), starting at the coefficient's value in `others`, or at 0, and lie within the bounds
/// themselves. Throws std::runtime_error if neither start is within the bounds.
Interval coefficient_limits(const Distortion& others, Coefficient which, const Eigen::AlignedBox2d& rectangle,
                            const LensBounds& bounds);

/// How far the principal point may be shifted from the image's centre.
struct PrincipalPointBounds {
  double max_shift_x = 0.03;  ///< fraction of the width
  double max_shift_y = 0.08;  ///< fraction of the height; KITTI needs .062
  double max_zoom = 3;        ///< of the border-free crop

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

enum class PrincipalPointAxis { cx, cy };

/// The interval of cx (or cy), pixels of the final image, around the image's centre in which the crop stays
/// within the zoom cap, with the other coordinate as in `principal_point_px`. Only the centre if the centre
/// itself exceeds the cap.
Interval principal_point_limits(const Distortion& lens, const Pinhole& base,
                                const Eigen::Vector2d& principal_point_px, PrincipalPointAxis which,
                                const PrincipalPointBounds& bounds);

}  // namespace cps
