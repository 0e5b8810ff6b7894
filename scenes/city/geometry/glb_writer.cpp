#include "scenes/city/geometry/glb_writer.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "files/files.h"

namespace cps::city {
namespace {

using nlohmann::ordered_json;

// Component types and buffer targets (glTF 2.0, section 5).
constexpr int unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125, float_32 = 5126;
constexpr int array_buffer = 34962, element_array_buffer = 34963, no_target = 0;

std::vector<std::uint8_t> encode_png(const Image& image) {
  std::vector<std::uint8_t> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  const auto output = OIIO::ImageOutput::create("texture.png", &proxy);
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  spec["oiio:UnassociatedAlpha"] = 1;  // glTF's alpha is straight: write the colours as they are
  if (!output || !output->open("texture.png", spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()) || !output->close())
    throw std::runtime_error("texture: could not be encoded as PNG: check the OpenImageIO installation");
  return bytes;
}

/// Rounds to 0.1 mm, which keeps the JSON short.
double rounded(double x) {
  return std::round(x * 1e4) / 1e4;
}

/// Whether every normal is its triangle's geometric normal. Then glTF (3.7.2.1) lets the file omit the
/// normals, and readers make the same ones.
bool is_flat(const Surface& surface) {
  for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
    const auto p = [&](int k) { return surface.positions[surface.indices[t + k]]; };
    const Eigen::Vector3f face = (p(1) - p(0)).cross(p(2) - p(0));
    for (int k = 0; k < 3; ++k)
      if (face.dot(surface.normals[surface.indices[t + k]]) < 0.9999f * face.norm()) return false;
  }
  return true;
}

template <typename T>
void append(std::vector<std::uint8_t>& bytes, const T& value) {
  const auto* p = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), p, p + sizeof(T));
}

}  // namespace

int GlbWriter::add_view(const void* data, std::size_t size, int target, int stride) {
  binary.resize((binary.size() + 3) & ~std::size_t{3});
  ordered_json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", size}};
  if (stride > 0) view["byteStride"] = stride;
  if (target != no_target) view["target"] = target;
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  binary.insert(binary.end(), bytes, bytes + size);
  views.push_back(std::move(view));
  return static_cast<int>(views.size()) - 1;
}

int GlbWriter::add_texture(const std::string& name, const Image& image) {
  const std::vector<std::uint8_t> png = encode_png(image);
  const int view = add_view(png.data(), png.size(), no_target, 0);
  images.push_back({{"name", name}, {"bufferView", view}, {"mimeType", "image/png"}});
  textures.push_back({{"name", name}, {"sampler", 0}, {"source", images.size() - 1}});
  return static_cast<int>(textures.size()) - 1;
}

MaterialId GlbWriter::add_material(const MaterialDescription& m) {
  ordered_json pbr = {{"baseColorFactor", {m.base_color[0], m.base_color[1], m.base_color[2], 1.0}},
                      {"metallicFactor", m.metallic},
                      {"roughnessFactor", m.roughness}};
  if (m.base_color_texture >= 0) pbr["baseColorTexture"] = {{"index", m.base_color_texture}};
  if (m.metallic_roughness_texture >= 0)
    pbr["metallicRoughnessTexture"] = {{"index", m.metallic_roughness_texture}};
  ordered_json material = {{"name", m.name}, {"pbrMetallicRoughness", std::move(pbr)}};
  if (m.normal_texture >= 0) material["normalTexture"] = {{"index", m.normal_texture}};
  if (m.emissive != std::array<double, 3>{0, 0, 0}) material["emissiveFactor"] = m.emissive;
  if (m.alpha_mask) {
    material["alphaMode"] = "MASK";
    material["alphaCutoff"] = 0.5;
  }
  if (m.transmission > 0)
    material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = m.transmission;
  if (m.double_sided) material["doubleSided"] = true;
  materials.push_back(std::move(material));
  return static_cast<MaterialId>(materials.size()) - 1;
}

int GlbWriter::add_mesh(const Mesh& mesh) {
  // Arrays of the same element size share a buffer view, which keeps the JSON small.
  enum Packing { vectors, coordinates, colors, short_indices, long_indices };
  struct Packed {
    std::vector<std::uint8_t> bytes;
    std::vector<int> accessors;
  };
  std::array<Packed, 5> packed;
  const auto pack = [&](Packing packing, const auto& values, ordered_json accessor) {
    Packed& target = packed[packing];
    accessor["byteOffset"] = target.bytes.size();
    accessor["count"] = values.size();
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    target.bytes.insert(target.bytes.end(), bytes, bytes + values.size() * sizeof(values[0]));
    target.accessors.push_back(static_cast<int>(accessors.size()));
    accessors.push_back(std::move(accessor));
    return target.accessors.back();
  };

  ordered_json primitives = ordered_json::array();
  for (const auto& [material, surface] : mesh.surfaces) {
    if (surface.indices.empty()) continue;
    Eigen::Vector3f low = surface.positions[0], high = low;
    for (const Eigen::Vector3f& p : surface.positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    ordered_json attributes;
    attributes["POSITION"] = pack(vectors, surface.positions,
                                  {{"componentType", float_32},
                                   {"type", "VEC3"},
                                   {"min", {low.x(), low.y(), low.z()}},
                                   {"max", {high.x(), high.y(), high.z()}}});
    if (!is_flat(surface))
      attributes["NORMAL"] = pack(vectors, surface.normals, {{"componentType", float_32}, {"type", "VEC3"}});
    if (materials[material]["pbrMetallicRoughness"].contains("baseColorTexture"))
      attributes["TEXCOORD_0"] =
          pack(coordinates, surface.uvs, {{"componentType", float_32}, {"type", "VEC2"}});
    if (!surface.colors.empty())
      attributes["COLOR_0"] = pack(
          colors, surface.colors, {{"componentType", unsigned_byte}, {"normalized", true}, {"type", "VEC4"}});
    int indices = 0;
    if (surface.positions.size() <= 65535)
      indices =
          pack(short_indices, std::vector<std::uint16_t>(surface.indices.begin(), surface.indices.end()),
               {{"componentType", unsigned_short}, {"type", "SCALAR"}});
    else
      indices = pack(long_indices, surface.indices, {{"componentType", unsigned_int}, {"type", "SCALAR"}});
    primitives.push_back(
        {{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}});
  }
  constexpr std::array<int, 5> strides{12, 8, 4, 0, 0};
  for (std::size_t i = 0; i < packed.size(); ++i) {
    if (packed[i].bytes.empty()) continue;
    const int view = add_view(packed[i].bytes.data(), packed[i].bytes.size(),
                              strides[i] > 0 ? array_buffer : element_array_buffer, strides[i]);
    for (int accessor : packed[i].accessors) accessors[accessor]["bufferView"] = view;
  }
  meshes.push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
  mesh_triangles.push_back(mesh.triangle_count());
  triangles += mesh.triangle_count();
  return static_cast<int>(meshes.size()) - 1;
}

int GlbWriter::add_variant(int mesh, const std::string& name, MaterialId from, MaterialId to) {
  ordered_json variant = meshes[mesh];
  variant["name"] = name;
  for (ordered_json& primitive : variant["primitives"])
    if (primitive["material"] == from) primitive["material"] = to;
  meshes.push_back(std::move(variant));
  mesh_triangles.push_back(mesh_triangles[mesh]);
  return static_cast<int>(meshes.size()) - 1;
}

void GlbWriter::add_node(const std::string& name, int mesh, const Placement& p) {
  ordered_json node = {{"name", name}, {"mesh", mesh}};
  if (p.position != Vec3::Zero())
    node["translation"] = {rounded(p.position.x()), rounded(p.position.y()), rounded(p.position.z())};
  if (p.heading_rad != 0 || p.up.y() != 1) {
    // Not rounded: glTF requires quaternions of unit length to six digits.
    const Eigen::Quaternionf q = (Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), p.up) *
                                  Eigen::AngleAxisd(p.heading_rad, Vec3::UnitY()))
                                     .cast<float>();
    node["rotation"] = {q.x(), q.y(), q.z(), q.w()};
  }
  if (p.scale != 1) node["scale"] = {rounded(p.scale), rounded(p.scale), rounded(p.scale)};
  nodes.push_back(std::move(node));
  placed_triangles += mesh_triangles[mesh];
}

std::size_t GlbWriter::write(const std::filesystem::path& file, const ordered_json& scene_extras) const {
  std::vector<int> roots(nodes.size());
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = static_cast<int>(i);
  const std::size_t padded = (binary.size() + 3) & ~std::size_t{3};
  ordered_json document = {
      {"asset", {{"version", "2.0"}, {"generator", "cps city"}}},
      {"scene", 0},
      {"scenes", {{{"name", "city"}, {"nodes", roots}, {"extras", scene_extras}}}},
      {"nodes", nodes},
      {"meshes", meshes},
      {"materials", materials},
      {"textures", textures},
      {"images", images},
      {"samplers", {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}}},
      {"accessors", accessors},
      {"bufferViews", views},
      {"buffers", {{{"byteLength", padded}}}}};
  const bool transmits = std::any_of(materials.begin(), materials.end(),
                                     [](const ordered_json& m) { return m.contains("extensions"); });
  if (transmits) document["extensionsUsed"] = {"KHR_materials_transmission"};
  std::string json = document.dump();
  json.resize((json.size() + 3) & ~std::size_t{3}, ' ');

  std::vector<std::uint8_t> header;
  append(header, std::uint32_t{0x46546C67});  // "glTF"
  append(header, std::uint32_t{2});
  append(header, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + padded));
  append(header, static_cast<std::uint32_t>(json.size()));
  append(header, std::uint32_t{0x4E4F534A});  // "JSON"
  std::vector<std::uint8_t> chunk;
  append(chunk, static_cast<std::uint32_t>(padded));
  append(chunk, std::uint32_t{0x004E4942});  // "BIN"

  write_by_rename(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    const auto put = [&](const void* data, std::size_t size) {
      out.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    };
    put(header.data(), header.size());
    put(json.data(), json.size());
    put(chunk.data(), chunk.size());
    put(binary.data(), binary.size());
    put("\0\0\0", padded - binary.size());
    out.close();
    if (!out) throw std::runtime_error("choose a folder that may be written to and has room");
  });
  return 12 + 8 + json.size() + 8 + padded;
}

}  // namespace cps::city
