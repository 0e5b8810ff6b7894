#include "tests/trainer/images/orientation/drawings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"

namespace cps {
namespace {

double bar(double across) {
  return 128 + 100 * std::sin(across * 2 * std::numbers::pi / 12);
}

}  // namespace

GrayImage drawn(const ImageSize& size, const std::function<double(double x, double y)>& brightness) {
  GrayImage image{size, {}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      double sum = 0;
      for (int s = 0; s < 4; ++s)
        sum += brightness(x - .25 + .5 * (s & 1) - (size.width - 1) / 2.,
                          y - .25 + .5 * (s >> 1) - (size.height - 1) / 2.);
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(sum / 4, 0., 255.))));
    }
  return image;
}

GrayImage leaning_bars(const ImageSize& size, double slope) {
  return drawn(size, [=](double x, double y) { return bar(x - slope * y); });
}

GrayImage sloping_bars(const ImageSize& size, double slope) {
  return drawn(size, [=](double x, double y) { return bar(y - slope * x); });
}

GrayImage wall_grid(const CalibratedCamera& camera) {
  const Pinhole& pinhole = camera.pinhole;
  const FrameCertificate frame = certify_frame(camera.distortion, pinhole);
  const auto to_line_px = [&](double x) {  // distance to the nearest line, in undistorted pixels
    const double lines = x * pinhole.fx / 20;
    return std::abs(lines - std::round(lines)) * 20;
  };
  return drawn({pinhole.width, pinhole.height}, [&](double x, double y) {
    const Eigen::Vector2d pixel(x + (pinhole.width - 1) / 2., y + (pinhole.height - 1) / 2.);
    const Eigen::Vector2d wall =
        undistort(camera.distortion, frame.rectangle, to_plane(pinhole, pixel)).value();
    const double distance = std::min(to_line_px(wall.x()), to_line_px(wall.y())) / 1.5;
    return 220 - 180 * std::exp(-distance * distance / 2);
  });
}

GrayImage flipped(const GrayImage& image) {
  GrayImage result = image;
  for (int y = 0; y < image.size.height; ++y)
    std::reverse(result.pixels.begin() + y * image.size.width,
                 result.pixels.begin() + (y + 1) * image.size.width);
  return result;
}

}  // namespace cps
