#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// The bytes of a buffer view from `offset` to its end. Refuses a view that does not exist or reaches beyond
/// its buffer.
std::span<const unsigned char> bytes_of_view(const Document& document, int buffer_view, std::size_t offset,
                                             const std::string& where);

/// The elements of an accessor: `count` of them, `stride` bytes apart, each of `components` numbers, all
/// inside the accessor's buffer. A sparse accessor, or one without a buffer view (all zeros), owns a dense
/// copy.
struct Elements {
  const unsigned char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int components = 0;
  int component_type = 0;  ///< TINYGLTF_COMPONENT_TYPE_…
  bool normalized = false;
  std::vector<unsigned char> owned = {};
};

/// Reads an accessor, after checking every offset, size and stride. `where` names the accessor's user in
/// messages.
Elements elements(Document& document, int accessor, const std::string& where);

/// Component `c` of element `i` as a number; normalised integers become [0, 1] or [−1, 1] (glTF 2.0 §3.11).
/// Neither index is checked.
float component(const Elements& elements, std::size_t i, int c);

/// The elements with numbers `picked` (not checked: each must be < count). Refuses an accessor that does not
/// have N components.
template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_vectors(Document& document, const Elements& from,
                                                     const std::string& where,
                                                     std::span<const std::uint32_t> picked) {
  if (from.components != N)
    refuse(document, where,
           "must have " + std::to_string(N) + " components, has " + std::to_string(from.components));
  reserve_memory(document, where, picked.size(), N * sizeof(float));
  std::vector<Eigen::Matrix<float, N, 1>> vectors(picked.size());
  for (std::size_t i = 0; i < picked.size(); ++i)
    for (int c = 0; c < N; ++c) vectors[i][c] = component(from, picked[i], c);
  return vectors;
}

/// All elements of a scalar u8, u16 or u32 accessor; refuses other types and primitive-restart values.
std::vector<std::uint32_t> read_indices(Document& document, int accessor, const std::string& where);

}  // namespace cps::gltf
