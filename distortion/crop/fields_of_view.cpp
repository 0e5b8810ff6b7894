#include "distortion/crop/fields_of_view.h"

#include <cmath>

namespace cps {

FieldsOfView fields_of_view(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box) {
  const Pinhole& camera = calibrated.pinhole;
  const Eigen::AlignedBox2d frame = frame_on_plane(camera);
  const auto angle = [](double from, double to) { return std::atan(to) - std::atan(from); };
  return {.label_horizontal_rad = hfov_rad(camera),
          .label_vertical_rad = 2 * std::atan(0.5 * camera.height / camera.fy),
          .ideal_horizontal_rad = angle(frame.min().x(), frame.max().x()),
          .ideal_vertical_rad = angle(frame.min().y(), frame.max().y()),
          .seen = true_fov(calibrated.distortion, camera, box)};
}

}  // namespace cps
