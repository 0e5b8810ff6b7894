#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cps::gltf {

/// One file on its way to becoming a Scene: what tinygltf read of it, and what was found on the way.
struct Document {
  std::filesystem::path file;  ///< for messages
  tinygltf::Model model = {};
  std::vector<std::string> warnings = {};
  std::size_t decoded_bytes = 0;  ///< vertices, triangles and texels made so far
  std::size_t max_decoded_bytes = 0;
};

/// Throws std::runtime_error("<file>: <where>: <what>"), made one printable line.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& where,
                         const std::string& what);
[[noreturn]] void refuse(const Document& document, const std::string& where, const std::string& what);

/// Notes a finding that does not stop the import; the same text only once.
void warn(Document& document, const std::string& text);

/// To be called before `count` elements of `bytes_each` are allocated: refuses when the scene grows too
/// large.
void reserve_memory(Document& document, const std::string& where, std::size_t count, std::size_t bytes_each);

/// "meshes[3]": how JSON paths are written in messages.
std::string element(const char* array, std::size_t index);

/// True when `index` names an element of `array`; glTF leaves references unchecked, and so does tinygltf.
template <class T>
bool in_range(int index, const std::vector<T>& array) {
  return index >= 0 && static_cast<std::size_t>(index) < array.size();
}

}  // namespace cps::gltf
