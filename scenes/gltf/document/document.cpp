#include "scenes/gltf/document/document.h"

#include <algorithm>
#include <stdexcept>

namespace cps::gltf {
namespace {

/// The first line of the text, without control characters and cut to 400 bytes: names in a broken file may be
/// garbage.
std::string one_line(const std::string& text) {
  constexpr std::size_t max_length = 400;
  std::string line = text.substr(0, std::min(text.find('\n'), max_length));
  std::erase_if(line, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  return line;
}

}  // namespace

void refuse(const std::filesystem::path& file, const std::string& where, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + one_line(where + ": " + what));
}

void refuse(const Document& document, const std::string& where, const std::string& what) {
  refuse(document.file, where, what);
}

void warn(Document& document, const std::string& text) {
  const std::string line = one_line(text);
  if (std::find(document.warnings.begin(), document.warnings.end(), line) == document.warnings.end())
    document.warnings.push_back(line);
}

void reserve_memory(Document& document, const std::string& where, std::size_t count, std::size_t bytes_each) {
  const std::size_t left = document.max_decoded_bytes - document.decoded_bytes;
  if (bytes_each != 0 && count > left / bytes_each)
    refuse(document, where,
           "the scene would need more than " + std::to_string(document.max_decoded_bytes >> 20) +
               " MiB of vertices and texels: split it or shrink its textures");
  document.decoded_bytes += count * bytes_each;
}

std::string element(const char* array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

}  // namespace cps::gltf
