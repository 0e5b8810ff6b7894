#include "scenes/gltf/document/json_checks.h"

#include <cstdint>
#include <limits>
#include <string>

#include "scenes/gltf/document/document.h"
#include "scenes/gltf/document/extensions.h"

namespace cps::gltf {
namespace {

using nlohmann::json;

constexpr int max_depth = 100;

/// Properties that must be whole numbers if present ("[]": each element, "*": each member).
constexpr const char* whole_numbers[] = {
    "scene",
    "scenes[].nodes[]",
    "nodes[].mesh",
    "nodes[].skin",
    "nodes[].children[]",
    "meshes[].primitives[].material",
    "meshes[].primitives[].mode",
    "meshes[].primitives[].indices",
    "meshes[].primitives[].attributes.*",
    "meshes[].primitives[].targets[].*",
    "accessors[].bufferView",
    "accessors[].byteOffset",
    "accessors[].componentType",
    "accessors[].count",
    "accessors[].sparse.count",
    "accessors[].sparse.indices.bufferView",
    "accessors[].sparse.indices.byteOffset",
    "accessors[].sparse.indices.componentType",
    "accessors[].sparse.values.bufferView",
    "accessors[].sparse.values.byteOffset",
    "bufferViews[].buffer",
    "bufferViews[].byteOffset",
    "bufferViews[].byteLength",
    "bufferViews[].byteStride",
    "buffers[].byteLength",
    "materials[].pbrMetallicRoughness.baseColorTexture.index",
    "materials[].pbrMetallicRoughness.baseColorTexture.texCoord",
    "materials[].pbrMetallicRoughness.metallicRoughnessTexture.index",
    "materials[].pbrMetallicRoughness.metallicRoughnessTexture.texCoord",
    "materials[].normalTexture.index",
    "materials[].normalTexture.texCoord",
    "materials[].emissiveTexture.index",
    "materials[].emissiveTexture.texCoord",
    "textures[].source",
    "textures[].sampler",
    "images[].bufferView",
    "samplers[].magFilter",
    "samplers[].wrapS",
    "samplers[].wrapT",
    "skins[].inverseBindMatrices",
    "skins[].joints[]",
};

constexpr const char* numbers[] = {
    "nodes[].matrix[]",
    "nodes[].translation[]",
    "nodes[].rotation[]",
    "nodes[].scale[]",
    "nodes[].weights[]",
    "meshes[].weights[]",
    "materials[].emissiveFactor[]",
    "materials[].alphaCutoff",
    "materials[].pbrMetallicRoughness.baseColorFactor[]",
    "materials[].pbrMetallicRoughness.metallicFactor",
    "materials[].pbrMetallicRoughness.roughnessFactor",
    "materials[].normalTexture.scale",
    "extensions.KHR_lights_punctual.lights[].intensity",
    "extensions.KHR_lights_punctual.lights[].color[]",
    "extensions.KHR_lights_punctual.lights[].spot.innerConeAngle",
    "extensions.KHR_lights_punctual.lights[].spot.outerConeAngle",
};

bool is_whole_number(const json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
}

bool is_number(const json& value) {
  return value.is_number();
}

using Rule = bool (*)(const json&);

/// Follows `path` from `value`, whose own path is `place`, and applies `rule` to every value it leads to. On
/// failure `place` is the path of the value at fault.
bool holds(const json& value, std::string_view path, Rule rule, std::string& place) {
  if (path.empty()) return rule(value);
  const std::size_t dot = path.find('.'), length = place.size();
  std::string_view key = path.substr(0, dot);
  const std::string_view rest = dot == path.npos ? "" : path.substr(dot + 1);
  const auto holds_at = [&](const json& child) {
    if (!holds(child, rest, rule, place)) return false;
    place.resize(length);
    return true;
  };
  if (!value.is_object()) return false;
  if (key == "*") {
    for (const auto& [name, member] : value.items())
      if (place.append(".").append(name); !holds_at(member)) return false;
    return true;
  }
  const bool each_element = key.ends_with("[]");
  if (each_element) key.remove_suffix(2);
  const auto member = value.find(std::string(key));
  if (member == value.end()) return true;
  place.append(".").append(key);
  if (!each_element) return holds_at(*member);
  if (!member->is_array()) return false;
  for (std::size_t i = 0; i < member->size(); ++i) {
    place.resize(length);
    place.append(".").append(key).append("[").append(std::to_string(i)).append("]");
    if (!holds_at((*member)[i])) return false;
  }
  place.resize(length);
  return true;
}

void check_numbers(const std::filesystem::path& file, const json& root) {
  const auto check = [&](const char* path, Rule rule, const char* kind) {
    std::string place;
    if (!holds(root, path, rule, place))
      refuse(file, place.substr(1), std::string("does not fit glTF's schema, where ") + path + " is " + kind);
  };
  for (const char* path : whole_numbers) check(path, is_whole_number, "a whole number, 0 to 2147483647");
  for (const char* path : numbers) check(path, is_number, "a number");
}

/// Whether brackets nest deeper than `limit`. Runs before parsing, on text that need not be JSON.
bool is_nested_deeper(std::string_view text, int limit) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size() && depth <= limit; ++i) {
    const char c = text[i];
    if (c == '"') in_string = !in_string;
    if (in_string && c == '\\') ++i;
    if (!in_string) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
  }
  return depth > limit;
}

json parse(const std::filesystem::path& file, std::string_view text) {
  if (is_nested_deeper(text, max_depth))
    refuse(file, "JSON", "nested deeper than " + std::to_string(max_depth) + " levels: is this a glTF file?");
  try {
    return json::parse(text.begin(), text.end());
  } catch (const json::exception& error) {
    refuse(file, "JSON", std::string("cannot be parsed (") + error.what() + "): is the file complete?");
  }
}

void check_version(const std::filesystem::path& file, const json& root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->value("version", json()).is_string())
    refuse(file, "asset.version", "is missing: is this a glTF file?");
  const std::string version = (*asset)["version"];
  if (!version.starts_with("2."))
    refuse(file, "asset.version", "is " + version + ", only glTF 2.0 is read: convert the file to 2.0");
  if (asset->value("minVersion", json("2.0")) != "2.0")
    refuse(file, "asset.minVersion", "is newer than 2.0, only glTF 2.0 is read");
}

}  // namespace

json parse_checked_json(const std::filesystem::path& file, std::string_view text) {
  json root = parse(file, text);
  if (!root.is_object()) refuse(file, "JSON", "its root must be an object: is this a glTF file?");
  check_version(file, root);
  check_required_extensions(file, root);
  check_numbers(file, root);
  return root;
}

}  // namespace cps::gltf
