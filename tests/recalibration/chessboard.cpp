#include "tests/recalibration/chessboard.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "numbers/angles.h"

namespace cps {
namespace {

constexpr int half_size = 60;  // squares from the middle to the board's rim
constexpr int squares_across_frame = 32;
constexpr int texels_per_square = 128;
constexpr int ramp_texels = 8;

/// Two by two squares. Black passes into white over a few texels, symmetrically, so that corners stay where
/// they are and few samples a pixel suffice to place an edge.
Texture two_by_two_squares() {
  Texture texture;
  texture.name = "squares";
  texture.width = texture.height = 2 * texels_per_square;
  // −1 in the first square of a row, 1 in the second, through 0 at their edges.
  const auto wave = [](int texel) {
    const double in_square = texel % texels_per_square + 0.5;
    const double from_edge = std::min(in_square, texels_per_square - in_square);
    return std::min(from_edge / (0.5 * ramp_texels), 1.0) * (texel < texels_per_square ? -1 : 1);
  };
  for (int y = 0; y < texture.height; ++y)
    for (int x = 0; x < texture.width; ++x) {
      const auto level = static_cast<std::uint8_t>(std::lround(110 + 90 * wave(x) * wave(y)));
      texture.rgba.insert(texture.rgba.end(), {level, level, level, 255});
    }
  return texture;
}

/// Two by two squares of the board, whose texture is as large.
void add_squares(Mesh& mesh, int x, int y) {
  const auto first = static_cast<int>(mesh.positions.size());
  for (const auto& [dx, dy] : {std::pair{0, 0}, {2, 0}, {2, 2}, {0, 2}}) {
    mesh.positions.emplace_back(x + dx, y + dy, 0);
    mesh.normals.emplace_back(0, 0, 1);
    mesh.uv0.emplace_back(0.5f * dx, 1 - 0.5f * dy);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

}  // namespace

Scene chessboard_scene() {
  Scene scene;
  scene.textures = {two_by_two_squares()};
  Material board;
  board.name = "board";
  board.metallic = 0;
  board.base_color_texture.texture = 0;
  scene.materials = {board};
  scene.meshes.resize(1);
  scene.instances.resize(1);
  for (int y = -half_size; y < half_size; y += 2)
    for (int x = -half_size; x < half_size; x += 2) add_squares(scene.meshes[0], x, y);
  return scene;
}

Eigen::Isometry3d chessboard_pose(const Pinhole& base, Stream stream, std::uint64_t index) {
  const Stream s = substream(stream, index);
  const double half_diagonal_deg = degrees(std::atan(0.5 * frame_on_plane(base).diagonal().norm()));
  const double tilt = radians(random_uniform(s, 0, 15, std::clamp(80 - half_diagonal_deg, 20.0, 40.0)));
  const double direction = random_uniform(s, 1, 0, 2 * std::numbers::pi);
  const double roll = random_uniform(s, 2, -std::numbers::pi, std::numbers::pi);
  const double distance = random_uniform(s, 3, 0.8, 1.2) * squares_across_frame * base.fx / base.width;
  const Eigen::Vector3d target(random_uniform(s, 4, -1, 1), random_uniform(s, 5, -1, 1), 0);

  const Eigen::Vector3d tilt_axis(std::cos(direction), std::sin(direction), 0);
  Eigen::Isometry3d pose;
  // The camera's z is forward: half a turn about x makes it face the board with y down.
  pose.linear() =
      (Eigen::AngleAxisd(tilt, tilt_axis) * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()) *
       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  pose.translation() = target - distance * pose.linear().col(2);
  pose.makeAffine();
  return pose;
}

std::vector<BoardCorner> visible_corners(const Eigen::Isometry3d& world_from_camera, const Pinhole& camera,
                                         const Distortion& lens, const Eigen::AlignedBox2d& seen,
                                         double border_px, double min_square_px) {
  const Eigen::Isometry3d camera_from_world = world_from_camera.inverse();
  const auto project = [&](double x, double y) -> std::optional<Eigen::Vector2d> {
    const Eigen::Vector3d p = camera_from_world * Eigen::Vector3d(x, y, 0);
    if (p.z() <= 0 || !seen.contains(p.hnormalized())) return {};
    return to_pixel(camera, distort(lens, p.hnormalized()));
  };
  const Eigen::AlignedBox2d inside(
      Eigen::Vector2d::Constant(border_px),
      Eigen::Vector2d(camera.width - 1 - border_px, camera.height - 1 - border_px));
  constexpr double step = 0.2;

  std::vector<BoardCorner> corners;
  for (int y = 1 - half_size; y < half_size; ++y)
    for (int x = 1 - half_size; x < half_size; ++x) {
      const auto here = project(x, y);
      if (!here || !inside.contains(*here)) continue;
      const auto left = project(x - step, y), right = project(x + step, y);
      const auto below = project(x, y - step), above = project(x, y + step);
      if (!left || !right || !below || !above) continue;
      const Eigen::Vector2d along_x = (*right - *left) / (2 * step), along_y = (*above - *below) / (2 * step);
      const double area = std::abs(along_x.x() * along_y.y() - along_x.y() * along_y.x());
      if (std::min(along_x.norm(), along_y.norm()) < min_square_px) continue;
      if (area < std::sin(radians(35)) * along_x.norm() * along_y.norm()) continue;
      corners.push_back({.on_board = {static_cast<double>(x), static_cast<double>(y)}, .pixel = *here});
    }
  return corners;
}

}  // namespace cps
