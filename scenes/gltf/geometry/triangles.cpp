#include "scenes/gltf/geometry/triangles.h"

#include <algorithm>
#include <limits>

namespace cps::gltf {

std::vector<std::uint32_t> triangle_corners(Document& document, int mode,
                                            std::span<const std::uint32_t> indices,
                                            const std::string& where) {
  const bool list = mode == TINYGLTF_MODE_TRIANGLES, strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
  if (indices.size() < 3 || (list && indices.size() % 3 != 0))
    refuse(document, where, std::to_string(indices.size()) + " corners do not make whole triangles");
  const std::size_t count = list ? indices.size() / 3 : indices.size() - 2;
  reserve_memory(document, where, count, 3 * sizeof(std::uint32_t));
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t odd = i % 2;  // glTF 2.0 §3.7.2.1
    const std::uint32_t a = list ? indices[3 * i] : strip ? indices[i] : indices[i + 1];
    const std::uint32_t b = list ? indices[3 * i + 1] : strip ? indices[i + 1 + odd] : indices[i + 2];
    const std::uint32_t c = list ? indices[3 * i + 2] : strip ? indices[i + 2 - odd] : indices[0];
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
  }
  return corners;
}

CompactTriangles compact(Document& document, std::span<const std::uint32_t> corners,
                         const std::string& where) {
  CompactTriangles result;
  if (corners.empty()) return result;
  const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end());
  const std::uint32_t first = *lowest;
  const std::size_t range = std::size_t{*highest} - first + 1;
  if (corners.size() > std::numeric_limits<int>::max()) refuse(document, where, "has more than 2^31 corners");
  reserve_memory(document, where, range, sizeof(std::uint32_t));
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_number(range, unused);
  for (const std::uint32_t corner : corners) new_number[corner - first] = 0;
  for (std::size_t i = 0; i < range; ++i) {
    if (new_number[i] == unused) continue;
    new_number[i] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(static_cast<std::uint32_t>(first + i));
  }
  reserve_memory(document, where, corners.size(), sizeof(int));
  result.triangles.resize(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.triangles[i / 3][i % 3] = static_cast<int>(new_number[corners[i] - first]);
  return result;
}

}  // namespace cps::gltf
