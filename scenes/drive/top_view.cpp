#include "scenes/drive/top_view.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numbers/srgb.h"
#include "scenes/enclosures.h"
#include "scenes/scene_rays.h"
#include "scenes/surface_color.h"

namespace cps {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

/// The part of the ground plane that is shown, and its scale.
struct Window {
  Vector2d corner = {0, 0};  ///< x and z of the picture's top-left corner
  double metres_per_px = 1;
  int width = 0, height = 0;
  Vector2d pixel_of(const Vector3f& point) const {
    return (Vector2d(point.x(), point.z()) - corner) / metres_per_px;
  }
};

Window window_of(const Scene& scene, int max_side_px) {
  constexpr double margin_m = 40, max_ratio = 2;
  const Eigen::AlignedBox3d whole = bounds_without_enclosures(scene).cast<double>();
  Eigen::AlignedBox2d shown(Vector2d(whole.min().x(), whole.min().z()),
                            Vector2d(whole.max().x(), whole.max().z()));
  Eigen::AlignedBox2d driven;
  for (const Lane& lane : scene.lanes)
    for (const Vector3f& point : lane.points) driven.extend(Vector2d(point.x(), point.z()));
  if (!driven.isEmpty()) {
    const Vector2d margin = Vector2d::Constant(margin_m);
    const Eigen::AlignedBox2d around(driven.min() - margin, driven.max() + margin);
    if (shown.sizes().maxCoeff() > max_ratio * around.sizes().maxCoeff()) shown = around;
  }
  Window window{.corner = shown.min()};
  window.metres_per_px = std::max(shown.sizes().maxCoeff(), 1e-6) / max_side_px;
  window.width =
      std::clamp(static_cast<int>(std::ceil(shown.sizes().x() / window.metres_per_px)), 1, max_side_px);
  window.height =
      std::clamp(static_cast<int>(std::ceil(shown.sizes().y() / window.metres_per_px)), 1, max_side_px);
  return window;
}

/// Linear colour of what a point of the window shows: the uppermost surface, lit from the north-west.
Vector3f color_at(const Scene& scene, const SceneRays& rays, const Vector3f& above) {
  static const Vector3f to_light = Vector3f(-1, 1.4f, -1).normalized();
  constexpr float ambient = 0.45f, direct = 0.75f;
  const Vector3f background(0.012f, 0.014f, 0.018f);
  const auto hit = first_hit(rays, above, {0, -1, 0});
  if (!hit) return background;
  const Vector3f normal = hit->normal.y() > 0 ? hit->normal : Vector3f(-hit->normal);
  const auto fallen_m = static_cast<float>(hit->distance_m);
  const Vector3f point = above - Vector3f(0, fallen_m, 0) + (0.01f + 1e-5f * fallen_m) * normal;
  const bool is_lit = !first_hit(rays, point, to_light);
  const float light = ambient + (is_lit ? direct * std::max(0.0f, normal.dot(to_light)) : 0);
  return light * base_color_at(scene, *hit);
}

/// Dots so dense that they make a line.
void draw_line(OIIO::ImageBuf& picture, const Vector2d& from, const Vector2d& to, double radius_px,
               const Vector3f& color) {
  const int steps = 1 + static_cast<int>(2 * (to - from).norm());
  for (int step = 0; step <= steps; ++step) {
    const Vector2d at = from + (to - from) * step / steps;
    const int reach = static_cast<int>(std::ceil(radius_px));
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const int x = static_cast<int>(at.x()) + dx, y = static_cast<int>(at.y()) + dy;
        if (std::hypot(dx, dy) > radius_px || !picture.roi().contains(x, y)) continue;
        picture.setpixel(x, y, color.data());
      }
  }
}

/// Saturated, far from its neighbours' (steps of the golden ratio around the colour circle).
Vector3f color_of_lane(int lane) {
  const double hue = std::fmod(0.09 + lane * 0.618034, 1.0) * 6;
  const auto channel = [&](double offset) {
    const double distance = std::fmod(hue + offset, 6.0);
    return static_cast<float>(0.15 + 0.85 * std::clamp(std::abs(distance - 3) - 1, 0.0, 1.0));
  };
  return {channel(0), channel(4), channel(2)};
}

void draw_lanes(OIIO::ImageBuf& picture, const Window& window, const std::vector<Lane>& lanes) {
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Vector3f color = color_of_lane(static_cast<int>(i));
    const std::vector<Vector3f>& points = lanes[i].points;
    for (std::size_t p = 1; p < points.size(); ++p)
      draw_line(picture, window.pixel_of(points[p - 1]), window.pixel_of(points[p]), 1, color);
    const Vector2d start = window.pixel_of(points.front());
    draw_line(picture, start, start, 4, color);
  }
}

/// The largest round length (1, 2 or 5 times a power of ten) that is no longer than a quarter of the width.
double scale_bar_m(const Window& window) {
  const double limit_m = window.width * window.metres_per_px / 4;
  const double power = std::pow(10, std::floor(std::log10(limit_m)));
  return power * (limit_m >= 5 * power ? 5 : limit_m >= 2 * power ? 2 : 1);
}

void write_text(OIIO::ImageBuf& picture, int x, int y, int text_px, const std::string& text) {
  OIIO::ImageBufAlgo::render_text(picture, x, y, text, text_px, "DejaVuSans", {0.92f, 0.92f, 0.92f});
}

/// The caption in lines that fit the width, at blanks.
std::vector<std::string> lines_of(const std::string& caption, int characters) {
  std::vector<std::string> lines;
  std::size_t at = 0;
  while (at < caption.size()) {
    std::size_t end = std::min(caption.size(), at + characters);
    if (end < caption.size())
      if (const std::size_t blank = caption.rfind(' ', end); blank != caption.npos && blank > at) end = blank;
    lines.push_back(caption.substr(at, end - at));
    at = end + (end < caption.size() && caption[end] == ' ' ? 1 : 0);
  }
  return lines;
}

}  // namespace

OIIO::ImageBuf top_view(const Scene& scene, const std::string& caption, int max_side_px) {
  constexpr int samples_per_side = 2, text_px = 13, line_px = 17, min_width_px = 360;
  const Window window = window_of(scene, max_side_px);
  const int width = std::max(window.width, min_width_px);
  const std::vector<std::string> lines = lines_of(caption, width * 10 / (6 * text_px));
  const int footer_px = line_px * (static_cast<int>(lines.size()) + 1) + 10;
  OIIO::ImageBuf picture(OIIO::ImageSpec(width, window.height + footer_px, 3, OIIO::TypeDesc::UINT8));
  OIIO::ImageBufAlgo::fill(picture, {0.09f, 0.09f, 0.1f});

  const SceneRays rays(scene);
  const float top = scene.bounds.max().y() + 1;
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x) {
      Vector3f sum = Vector3f::Zero();
      for (int s = 0; s < samples_per_side * samples_per_side; ++s) {
        const Vector2d at = window.corner + window.metres_per_px *
                                                Vector2d(x + (s % samples_per_side + 0.5) / samples_per_side,
                                                         y + (s / samples_per_side + 0.5) / samples_per_side);
        sum += color_at(scene, rays, {static_cast<float>(at.x()), top, static_cast<float>(at.y())});
      }
      const Vector3f mean = sum / (samples_per_side * samples_per_side);
      const Vector3f encoded =
          mean.unaryExpr([](float c) { return static_cast<float>(srgb_from_linear(c)); });
      picture.setpixel(x, y, encoded.data());
    }
  draw_lanes(picture, window, scene.lanes);

  const double bar_m = scale_bar_m(window);
  const int bar_px = static_cast<int>(std::lround(bar_m / window.metres_per_px)),
            bar_y = window.height + line_px - 5;
  draw_line(picture, Vector2d(6, bar_y), Vector2d(6 + bar_px, bar_y), 1, Vector3f::Constant(0.92f));
  write_text(picture, 14 + bar_px, window.height + line_px, text_px, fmt::format("{:g} m", bar_m));
  for (std::size_t i = 0; i < lines.size(); ++i)
    write_text(picture, 6, window.height + line_px * (static_cast<int>(i) + 2), text_px, lines[i]);
  return picture;
}

}  // namespace cps
