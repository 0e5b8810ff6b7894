#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cps::gltf {

/// A file being imported: its model as read by tinygltf, the warnings so far and the memory used so far.
struct Document {
  std::filesystem::path file;  ///< for messages
  tinygltf::Model model = {};
  std::vector<std::string> warnings = {};
  std::size_t decoded_bytes = 0;  ///< vertices, triangles and texels made so far
  std::size_t max_decoded_bytes = 0;
};

/// Throws std::runtime_error("<file>: <where>: <what>"), cut to one printable line.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& where,
                         const std::string& what);
[[noreturn]] void refuse(const Document& document, const std::string& where, const std::string& what);

/// Adds a warning, unless the same text is there already.
void warn(Document& document, const std::string& text);

/// Counts `count` elements of `bytes_each` towards the scene's memory; call it before allocating them.
/// Refuses the file when the sum exceeds `max_decoded_bytes`.
void reserve_memory(Document& document, const std::string& where, std::size_t count, std::size_t bytes_each);

/// A JSON path for messages: "meshes[3]".
std::string element(const char* array, std::size_t index);

/// Whether `index` names an element of `array`. Files may hold references to nothing, and tinygltf does not
/// check them.
template <class T>
bool in_range(int index, const std::vector<T>& array) {
  return index >= 0 && static_cast<std::size_t>(index) < array.size();
}

}  // namespace cps::gltf
