#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/calibrated_camera.h"
#include "distortion/crop/true_fov.h"

namespace cps {

/// Everything that is called the field of view of one camera, radians. The three agree only for an
/// undistorted camera with a centred principal point.
struct FieldsOfView {
  /// 2·atan(W / 2fx) and 2·atan(H / 2fy): what a label says. Knows neither lens nor principal point.
  double label_horizontal_rad = 0, label_vertical_rad = 0;
  /// Left plus right half angle, upper plus lower, of the camera without its lens: what a simulator that
  /// renders its ideal image has to cover when the principal point is off-centre.
  double ideal_horizontal_rad = 0, ideal_vertical_rad = 0;
  /// What the image really shows; empty when it sees beyond the rectangle on which the lens is certified.
  std::optional<TrueFov> seen;
};

/// `box` as for true_fov(): FrameCertificate::rectangle of a valid certificate.
FieldsOfView fields_of_view(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box);

}  // namespace cps
