#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/files.h"

namespace cps {

/// Writes street.gltf and street.bin: a ground plane, rows of boxes between six parallel streets, and their
/// lanes.
inline std::filesystem::path write_street_gltf(const std::filesystem::path& folder) {
  using Json = nlohmann::ordered_json;
  std::vector<float> positions = {-200, 0, -200, 200, 0, -200, 200, 0, 200, -200, 0, 200};
  std::vector<std::uint32_t> ground = {0, 2, 1, 0, 3, 2}, box;
  for (float z : {0.f, 1.f})
    for (float y : {0.f, 1.f})
      for (float x : {0.f, 1.f}) positions.insert(positions.end(), {x - 0.5f, y, z - 0.5f});
  for (std::uint32_t i :
       {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 2, 6, 7, 2, 7, 3})
    box.push_back(i);
  std::string bin(reinterpret_cast<const char*>(positions.data()), positions.size() * 4);
  bin.append(reinterpret_cast<const char*>(ground.data()), ground.size() * 4);
  bin.append(reinterpret_cast<const char*>(box.data()), box.size() * 4);
  write_file(folder / "street.bin", bin);

  Json nodes = {{{"mesh", 0}}}, lanes = Json::array();
  for (int s = 0; s < 6; ++s) {
    const double z = -60 + 24 * s;
    for (int b = 0; b < 12; ++b)
      nodes.push_back({{"mesh", 1},
                       {"translation", {-170 + 30 * b, 0, z + 12}},
                       {"scale", {14, 5 + (b * 7 + s) % 9, 9}}});
    lanes.push_back(
        {{"street", fmt::format("s{}", s)}, {"width_m", 3.5}, {"points", {{-150, 0, z}, {150, 0, z}}}});
  }
  Json all_nodes = Json::array();
  for (std::size_t n = 0; n < nodes.size(); ++n) all_nodes.push_back(n);
  const Json primitive_ground = {{"attributes", {{"POSITION", 0}}}, {"indices", 2}, {"material", 0}};
  const Json primitive_box = {{"attributes", {{"POSITION", 1}}}, {"indices", 3}, {"material", 1}};
  const std::size_t floats = positions.size() * 4, ground_bytes = ground.size() * 4,
                    box_bytes = box.size() * 4;
  const Json gltf = {
      {"asset", {{"version", "2.0"}, {"copyright", "made by a test"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", all_nodes}, {"extras", {{"cps_lanes", lanes}}}}}},
      {"nodes", nodes},
      {"meshes", {{{"primitives", {primitive_ground}}}, {{"primitives", {primitive_box}}}}},
      {"materials",
       {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.3, 0.3, 0.3, 1}}, {"metallicFactor", 0}}}},
        {{"pbrMetallicRoughness", {{"baseColorFactor", {0.6, 0.4, 0.3, 1}}, {"metallicFactor", 0}}}}}},
      {"buffers", {{{"uri", "street.bin"}, {"byteLength", bin.size()}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", floats}},
        {{"buffer", 0}, {"byteOffset", floats}, {"byteLength", ground_bytes}},
        {{"buffer", 0}, {"byteOffset", floats + ground_bytes}, {"byteLength", box_bytes}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", 5126},
         {"count", 4},
         {"type", "VEC3"},
         {"min", {-200, 0, -200}},
         {"max", {200, 0, 200}}},
        {{"bufferView", 0},
         {"byteOffset", 48},
         {"componentType", 5126},
         {"count", 8},
         {"type", "VEC3"},
         {"min", {-0.5, 0, -0.5}},
         {"max", {0.5, 1, 0.5}}},
        {{"bufferView", 1}, {"componentType", 5125}, {"count", ground.size()}, {"type", "SCALAR"}},
        {{"bufferView", 2}, {"componentType", 5125}, {"count", box.size()}, {"type", "SCALAR"}}}}};
  write_json(folder / "street.gltf", gltf);
  return folder / "street.gltf";
}

}  // namespace cps
