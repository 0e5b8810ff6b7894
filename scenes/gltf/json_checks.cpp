#include "scenes/gltf/json_checks.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "scenes/gltf/document.h"

namespace cps::gltf {
namespace {

using nlohmann::json;

constexpr int max_depth = 100;

constexpr std::array read_extensions = {
    "EXT_texture_webp",
    "KHR_materials_emissive_strength",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

json parse(const std::filesystem::path& file, std::string_view text) {
  const auto too_deep = [&](int depth, json::parse_event_t, json&) {
    if (depth > max_depth)
      refuse(file, "JSON",
             "nested deeper than " + std::to_string(max_depth) + " levels: not a sane glTF file");
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), too_deep);
  } catch (const json::exception& error) {
    refuse(file, "JSON", std::string("cannot be parsed (") + error.what() + "): is the file complete?");
  }
}

/// `object[key]`, where it exists, must be a whole number from 0 to `largest`.
void check_whole_number(const std::filesystem::path& file, const std::string& where, const json& object,
                        const char* key, std::uint64_t largest) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > largest)
    refuse(file, where + "." + key, "must be a whole number, 0 to " + std::to_string(largest));
}

struct WholeNumbers {
  const char* array;
  std::vector<const char*> indices, bytes;
};

void check_whole_numbers(const std::filesystem::path& file, const json& root) {
  constexpr std::uint64_t largest_index = std::numeric_limits<int>::max();
  constexpr std::uint64_t largest_size = std::uint64_t{1} << 40;
  static const std::vector<WholeNumbers> table = {
      {"accessors", {"bufferView", "componentType"}, {"byteOffset", "count"}},
      {"buffers", {}, {"byteLength"}},
      {"bufferViews", {"buffer", "target"}, {"byteOffset", "byteLength", "byteStride"}},
      {"images", {"bufferView"}, {}},
      {"nodes", {"mesh", "skin", "camera"}, {}},
      {"textures", {"source", "sampler"}, {}},
      {"samplers", {"magFilter", "minFilter", "wrapS", "wrapT"}, {}},
  };
  check_whole_number(file, "glTF", root, "scene", largest_index);
  for (const WholeNumbers& entry : table) {
    const auto array = root.find(entry.array);
    if (array == root.end()) continue;
    if (!array->is_array()) refuse(file, entry.array, "must be an array");
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string where = element(entry.array, i);
      if (!(*array)[i].is_object()) refuse(file, where, "must be a JSON object");
      for (const char* key : entry.indices) check_whole_number(file, where, (*array)[i], key, largest_index);
      for (const char* key : entry.bytes) check_whole_number(file, where, (*array)[i], key, largest_size);
    }
  }
}

void check_version(const std::filesystem::path& file, const json& root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string())
    refuse(file, "asset.version", "is missing: is this a glTF file?");
  const std::string version = (*asset)["version"];
  if (version.rfind("2.", 0) != 0)
    refuse(file, "asset.version", "is " + version + ", only glTF 2.0 is read: convert the file to 2.0");
  if (asset->contains("minVersion") && (*asset)["minVersion"] != "2.0")
    refuse(file, "asset.minVersion", "is newer than 2.0, only glTF 2.0 is read");
}

void check_extensions(const std::filesystem::path& file, const json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  if (!required->is_array()) refuse(file, "extensionsRequired", "must be an array");
  for (const json& name : *required) {
    if (!name.is_string()) refuse(file, "extensionsRequired", "must hold names");
    const std::string extension = name;
    if (std::find(read_extensions.begin(), read_extensions.end(), extension) == read_extensions.end())
      refuse(file, "extensionsRequired", extension + " is not supported: export the file again without it");
  }
}

}  // namespace

json parse_checked_json(const std::filesystem::path& file, std::string_view text) {
  json root = parse(file, text);
  if (!root.is_object()) refuse(file, "JSON", "its root must be an object: is this a glTF file?");
  check_version(file, root);
  check_extensions(file, root);
  check_whole_numbers(file, root);
  return root;
}

}  // namespace cps::gltf
