#include "scenes/inside_out.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace cps {
namespace {

constexpr double max_open_edges = 0.1;
constexpr double max_opening = 0.6;

/// Six times the signed volume between the triangles and the vertices' mean: negative if the front faces look
/// inwards.
double signed_volume(const Mesh& mesh) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : mesh.positions) centre += p.cast<double>();
  centre /= static_cast<double>(mesh.positions.size());
  double volume = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int i) -> Eigen::Vector3d {
      return mesh.positions[t[i]].cast<double>() - centre;
    };
    volume += corner(0).dot(corner(1).cross(corner(2)));
  }
  return volume;
}

/// The opening of a shell as a share of its surface: the length of the sum of its area vectors over the sum
/// of their lengths. 0 for a closed shell, 0.5 for a dome without a floor, near 1 for ground.
double opening(const Mesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int i) -> Eigen::Vector3d { return mesh.positions[t[i]].cast<double>(); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    sum += normal;
    area += normal.norm();
  }
  return area > 0 ? sum.norm() / area : 1;
}

/// Numbers the vertices' positions, so that vertices split for their normals or uv share a number.
std::vector<int> position_numbers(const Mesh& mesh) {
  const auto key = [&](int i) {
    const Eigen::Vector3f& p = mesh.positions[i];
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::vector<int> order(mesh.positions.size()), numbers(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
    numbers[order[i]] = numbers[order[i - 1]] + (key(order[i]) != key(order[i - 1]) ? 1 : 0);
  return numbers;
}

/// Share of triangle edges without a neighbour, that is, a triangle with the same edge in opposite direction.
double open_edges(const Mesh& mesh) {
  const std::vector<int> position = position_numbers(mesh);
  std::vector<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.emplace_back(position[t[i]], position[t[(i + 1) % 3]]);
  std::sort(edges.begin(), edges.end());
  const auto is_open = [&](const std::pair<int, int>& edge) {
    return !std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
  };
  return static_cast<double>(std::count_if(edges.begin(), edges.end(), is_open)) /
         static_cast<double>(edges.size());
}

}  // namespace

bool is_inside_out(const Mesh& mesh) {
  if (mesh.triangles.empty() || signed_volume(mesh) >= 0) return false;
  return opening(mesh) <= max_opening && open_edges(mesh) <= max_open_edges;
}

}  // namespace cps
