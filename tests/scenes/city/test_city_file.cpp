#include <tiny_gltf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "scenes/city/city.h"
#include "scenes/city/streets/terrain.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <typename T>
const T* data_of(const tinygltf::Model& model, int accessor) {
  const tinygltf::BufferView& view = model.bufferViews[model.accessors[accessor].bufferView];
  return reinterpret_cast<const T*>(
      &model.buffers[view.buffer].data[view.byteOffset + model.accessors[accessor].byteOffset]);
}

void check_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const tinygltf::Accessor& positions = model.accessors[primitive.attributes.at("POSITION")];
  const float* p = data_of<float>(model, primitive.attributes.at("POSITION"));
  for (std::size_t i = 0; i < positions.count * 3; ++i)
    if (!(p[i] >= positions.minValues[i % 3] && p[i] <= positions.maxValues[i % 3]))
      FAIL_CHECK("position outside min/max");
  const auto normals = primitive.attributes.find("NORMAL");  // flat surfaces have none
  const bool is_flat = normals == primitive.attributes.end();
  const float* n = is_flat ? nullptr : data_of<float>(model, normals->second);
  for (std::size_t i = 0; i < positions.count && !is_flat; ++i)
    if (std::abs(std::hypot(n[3 * i], n[3 * i + 1], n[3 * i + 2]) - 1) > 1e-4)
      FAIL_CHECK("normal is not a unit vector");
  if (const auto uv = primitive.attributes.find("TEXCOORD_0"); uv != primitive.attributes.end()) {
    const float* t = data_of<float>(model, uv->second);
    for (std::size_t i = 0; i < positions.count * 2; ++i)
      if (!std::isfinite(t[i])) FAIL_CHECK("texture coordinate is not finite");
  }
  const tinygltf::Accessor& indices = model.accessors[primitive.indices];
  CHECK(indices.count % 3 == 0);
  for (std::size_t i = 0; i < indices.count; ++i) {
    const std::uint32_t index = indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                                    ? data_of<std::uint16_t>(model, primitive.indices)[i]
                                    : data_of<std::uint32_t>(model, primitive.indices)[i];
    if (index >= positions.count) FAIL_CHECK("index out of range");
  }
}

}  // namespace

TEST_CASE("the same options give the same city file, and it is valid glTF") {
  const TemporaryFolder folder;
  const fs::path first = folder.path / "first.glb", again = folder.path / "again.glb",
                 other = folder.path / "other.glb";
  const CityOptions options{.seed = 7, .style = CityStyle::mixed, .extent_m = 300};
  const CitySummary summary = write_city(options, first);
  write_city(options, again);
  write_city({.seed = 8, .extent_m = 300}, other);
  const std::string bytes = bytes_of(first);
  CHECK((bytes == bytes_of(again)));
  CHECK((bytes != bytes_of(other)));
  CHECK(bytes.size() == summary.bytes);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path))
    CHECK(entry.path().extension() == ".glb");

  std::uint32_t header[3];
  std::memcpy(header, bytes.data(), sizeof header);
  CHECK(header[0] == 0x46546C67);
  CHECK(header[1] == 2);
  CHECK(header[2] == bytes.size());

  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error, warning;
  REQUIRE(reader.LoadBinaryFromMemory(&model, &error, &warning,
                                      reinterpret_cast<const unsigned char*>(bytes.data()),
                                      static_cast<unsigned>(bytes.size())));
  CHECK(error.empty());
  CHECK(warning.empty());
  std::size_t triangles = 0;
  for (const tinygltf::Mesh& mesh : model.meshes) {
    CHECK_FALSE(mesh.name.empty());
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      check_primitive(model, primitive);
      const tinygltf::Material& material = model.materials[primitive.material];
      if (material.normalTexture.index >= 0) CHECK(primitive.attributes.count("TEXCOORD_0") == 1);
    }
  }
  for (const tinygltf::Node& node : model.nodes) {
    CHECK_FALSE(node.name.empty());
    for (const tinygltf::Primitive& primitive : model.meshes[node.mesh].primitives)
      triangles += model.accessors[primitive.indices].count / 3;
  }
  CHECK(triangles == summary.instanced_triangles);
  for (const tinygltf::Image& image : model.images) CHECK(std::min(image.width, image.height) >= 512);
  for (const tinygltf::Material& material : model.materials) CHECK_FALSE(material.name.empty());

  CHECK(model.scenes[0].extras.Get("cps_city").Get("style").Get<std::string>() == "mixed");
  const tinygltf::Value lanes = model.scenes[0].extras.Get("cps_lanes");
  REQUIRE(lanes.ArrayLen() == summary.lanes);
  double km = 0;
  const city::Terrain terrain = city::draw_terrain(options);
  for (std::size_t i = 0; i < lanes.ArrayLen(); ++i) {
    const tinygltf::Value& lane = lanes.Get(static_cast<int>(i));
    CHECK(lane.Get("street").IsString());
    CHECK(lane.Get("width_m").GetNumberAsDouble() >= 3.0);
    const tinygltf::Value& points = lane.Get("points");
    REQUIRE(points.ArrayLen() >= 2);
    CHECK(lane.Get("next").ArrayLen() > 0);
    for (std::size_t k = 1; k < points.ArrayLen(); ++k) {
      const auto at = [&](std::size_t j, int axis) {
        return points.Get(static_cast<int>(j)).Get(axis).GetNumberAsDouble();
      };
      CHECK(at(k, 1) == Approx(terrain.height_m({at(k, 0), -at(k, 2)})).margin(0.002));
      km += std::hypot(at(k, 0) - at(k - 1, 0), at(k, 2) - at(k - 1, 2)) / 1000;
    }
  }
  CHECK(km == Approx(summary.lane_km).epsilon(1e-4));
}

TEST_CASE("a city's summary as text") {
  CitySummary summary;
  summary.style = CityStyle::suburb;
  summary.streets = 15;
  summary.junctions = 40;
  summary.blocks = 26;
  summary.buildings = 610;
  summary.trees = 2166;
  summary.cars = 133;
  summary.in_traffic = 69;
  summary.people = 90;
  summary.furniture = 3497;
  summary.lanes = 374;
  summary.lane_km = 11.46;
  summary.triangles = 619'000;
  summary.instanced_triangles = 7'284'000;
  summary.bytes = 37'460'000;
  CHECK(summary.brief() ==
        "suburb: 15 streets, 40 junctions, 26 blocks, 610 buildings, 2166 trees, 133 parked cars, 69 "
        "vehicles in "
        "traffic, 90 people, 3497 pieces of street furniture\n"
        "374 lanes, 11.5 km in all\n"
        "0.62 M triangles (7.28 M with instances), 37.5 MB");
}

TEST_CASE("an unknown style is refused with a list of the styles") {
  for (const std::string& name : city_style_names()) CHECK(to_string(city_style_from(name)) == name);
  CHECK_THROWS_WITH(city_style_from("village"), "is none of european, downtown, suburb, industrial, mixed");
}

TEST_CASE("the same options give the same file in every style, and the file names its style", "[slow]") {
  const TemporaryFolder folder;
  std::set<std::string> different;
  for (const std::string& name : city_style_names()) {
    INFO(name);
    const CityOptions options{.seed = 2, .style = city_style_from(name), .extent_m = 300};
    const CitySummary summary = write_city(options, folder.path / "first.glb");
    write_city(options, folder.path / "again.glb");
    const std::string bytes = bytes_of(folder.path / "first.glb");
    CHECK((bytes == bytes_of(folder.path / "again.glb")));
    CHECK(bytes.find("\"cps_city\":{\"style\":\"" + name + "\",\"seed\":2,\"traffic_seed\":0}") !=
          std::string::npos);
    CHECK(summary.brief().find(name + ": ") == 0);
    different.insert(bytes);
  }
  CHECK(different.size() == 5);
}

TEST_CASE("invalid options and unwritable files are refused and leave no file") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "city.glb";
  for (const CityOptions& bad : {CityOptions{.extent_m = 20}, CityOptions{.extent_m = std::nan("")},
                                 CityOptions{.tree_density = -1}, CityOptions{.parked_cars = 9}}) {
    CHECK_FALSE(bad.fault().empty());
    CHECK_THROWS_AS(write_city(bad, file), std::runtime_error);
  }
  CHECK(fs::is_empty(folder.path));
  fs::create_directory(file);  // a folder has the file's name
  CHECK_THROWS_WITH(write_city({.extent_m = 300}, file), Catch::Contains(file.string()));
  CHECK(fs::is_empty(file));
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}
