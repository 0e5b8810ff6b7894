#include "scenes/gltf/document/external_files.h"

#include <algorithm>
#include <charconv>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {
namespace {

namespace fs = std::filesystem;

/// RFC 3986 §2.1: "%20" is a space. A '%' without two hexadecimal digits stays.
std::string percent_decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char *digits = uri.data() + i + 1, *end = digits + 2;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, end, byte, 16).ptr == end) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The file that the URI names. Some exporters write file names without encoding them, or with backslashes.
fs::path file_of(const fs::path& folder, const std::string& uri) {
  std::string slashed = uri;
  std::ranges::replace(slashed, '\\', '/');
  const std::string decoded = percent_decoded(uri);
  for (const std::string& name : {decoded, uri, slashed}) {
    std::error_code error;
    // "/" in front of an absolute name keeps it inside the folder.
    if (const fs::path file = folder.string() + "/" + name; fs::is_regular_file(file, error)) return file;
  }
  return folder.string() + "/" + decoded;
}

}  // namespace

ExternalFiles replace_file_uris(const fs::path& gltf_file, const fs::path& folder, nlohmann::json& root) {
  ExternalFiles files;
  for (const char* list : {"buffers", "images"}) {
    const auto found = root.find(list);
    if (found == root.end() || !found->is_array()) continue;
    for (std::size_t i = 0; i < found->size(); ++i) {
      nlohmann::json& item = (*found)[i];
      if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) continue;
      const std::string uri = item["uri"];
      if (uri.starts_with("data:")) continue;
      const bool is_buffer = list == std::string_view("buffers");
      const fs::path path = file_of(folder, uri);
      std::error_code error;
      if (is_buffer && !fs::is_regular_file(path, error))
        refuse(gltf_file, element(list, i) + ".uri",
               "\"" + uri + "\" is not beside the glTF file: is it there?");
      const std::string stand_in = std::string(list) + "-" + std::to_string(i);
      files.by_stand_in[stand_in] = {path, uri, is_buffer ? item.value("byteLength", std::size_t{0}) : 0};
      item["uri"] = stand_in;
    }
  }
  return files;
}

}  // namespace cps::gltf
