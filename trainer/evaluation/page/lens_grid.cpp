#include "trainer/evaluation/page/lens_grid.h"

#include "distortion/certificate/frame_certificate.h"

namespace cps {
namespace {

using Eigen::Vector2d;

constexpr int grid_squares = 12, points_per_line = 64;

/// What of the line between two ideal points lies in the rectangle, in the picture.
void add_line(std::vector<GridCurve>& lines, const CalibratedCamera& camera,
              const Eigen::AlignedBox2d& one_to_one_part, const Vector2d& from, const Vector2d& to) {
  GridCurve line;
  const auto end_line = [&] {
    if (line.size() > 1) lines.push_back(line);
    line.clear();
  };
  for (int i = 0; i < points_per_line; ++i) {
    const double share = i / double(points_per_line - 1);
    const Vector2d ideal = from + share * (to - from);
    if (one_to_one_part.contains(ideal))
      line.push_back(to_pixel(camera.pinhole, distort(camera.distortion, ideal)) + Vector2d(.5, .5));
    else
      end_line();
  }
  end_line();
}

}  // namespace

std::vector<GridCurve> lens_grid(const CalibratedCamera& camera, const Eigen::AlignedBox2d& extent) {
  const FrameCertificate frame = certify_frame(camera.distortion, camera.pinhole, one_to_one);
  const Vector2d size = extent.sizes(), centre = extent.center();
  const double square = size.x() / grid_squares;
  const int rows = static_cast<int>(size.y() / square / 2);  // on either side of the middle one
  std::vector<GridCurve> lines;
  for (int i = 0; i <= grid_squares; ++i) {
    const double x = extent.min().x() + i * square;
    add_line(lines, camera, frame.rectangle, {x, extent.min().y()}, {x, extent.max().y()});
  }
  for (int i = -rows; i <= rows; ++i) {
    const double y = centre.y() + i * square;
    add_line(lines, camera, frame.rectangle, {extent.min().x(), y}, {extent.max().x(), y});
  }
  return lines;
}

}  // namespace cps
