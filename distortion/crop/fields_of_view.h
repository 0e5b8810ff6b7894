#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/calibrated_camera.h"
#include "distortion/crop/true_fov.h"

namespace cps {

/// The three things called "field of view" of one camera, radians. They agree only for an undistorted camera
/// with a centred principal point.
struct FieldsOfView {
  /// The label's: 2·atan(W / 2fx) and 2·atan(H / 2fy). Independent of lens and principal point.
  double label_horizontal_rad = 0, label_vertical_rad = 0;
  /// The ideal camera's (without its lens): left plus right half angle, upper plus lower half angle. A
  /// simulator that renders the ideal image has to cover these when the principal point is off-centre.
  double ideal_horizontal_rad = 0, ideal_vertical_rad = 0;
  /// The distorted image's; empty when it sees beyond the rectangle on which the lens is certified.
  std::optional<TrueFov> seen;
};

/// `box` as for true_fov(): FrameCertificate::rectangle of a valid certificate.
FieldsOfView fields_of_view(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box);

}  // namespace cps
