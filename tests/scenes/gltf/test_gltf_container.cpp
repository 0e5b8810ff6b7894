#include <catch2/catch.hpp>

#include "scenes/gltf_import.h"
#include "tests/scenes/gltf/gltf_maker.h"

using Catch::Matchers::StartsWith;

namespace {

std::vector<unsigned char> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

void put_u32(std::vector<unsigned char>& bytes, std::size_t offset, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[offset + i] = static_cast<unsigned char>(value >> (8 * i));
}

}  // namespace

TEST_CASE("a .glb, a data URI and an external file give the same scene") {
  const GltfMaker maker = one_square();
  const cps::Scene from_glb = import_glb(maker);
  const cps::Scene from_data_uri = import_bytes(bytes_of(maker.gltf()));

  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "my parts");
  const std::string text = maker.gltf("my%20parts/b.bin");
  write_file(folder.path / "square.gltf", text.data(), text.size());
  write_file(folder.path / "my parts" / "b.bin", maker.buffer.data(), maker.buffer.size());
  const cps::Scene from_file = cps::import_gltf(folder.path / "square.gltf");

  for (const cps::Scene* scene : {&from_glb, &from_data_uri, &from_file}) {
    REQUIRE(scene->meshes.size() == 1);
    CHECK(scene->meshes[0].positions == from_glb.meshes[0].positions);
    CHECK(scene->meshes[0].triangles == from_glb.meshes[0].triangles);
  }
  CHECK(from_glb.name == "scene");
  CHECK(from_file.name == "square");
}

TEST_CASE("many buffers of one large file, and JSON too long for the memory limit, are refused") {
  GltfMaker maker = one_triangle();
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "t.gltf";
  maker.buffer.resize(20000);
  auto root = nlohmann::json::parse(maker.gltf("b.bin"));
  for (int i = 0; i < 10; ++i) root["buffers"].push_back(root["buffers"][0]);
  const std::string text = root.dump();
  write_file(file, text.data(), text.size());
  write_file(folder.path / "b.bin", maker.buffer.data(), maker.buffer.size());
  CHECK(cps::import_gltf(file, 250000).meshes.size() == 1);
  CHECK_THROWS_WITH(cps::import_gltf(file, 150000),
                    Catch::Matchers::Contains("b.bin") && Catch::Matchers::Contains("more than may be read"));
  CHECK_THROWS_WITH(cps::import_gltf(file, 50000), file.string() + ": JSON: is longer than 390 bytes");
}

TEST_CASE("file names are relative to the glTF file's folder, absolute ones are refused") {
  const GltfMaker maker = one_triangle();
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "below");
  write_file(folder.path / "b.bin", maker.buffer.data(), maker.buffer.size());
  const std::filesystem::path file = folder.path / "below" / "t.gltf";
  const auto import_with = [&](const std::string& uri) {
    const std::string text = maker.gltf(uri);
    write_file(file, text.data(), text.size());
    return cps::import_gltf(file).meshes.size();
  };
  CHECK(import_with("../b.bin") == 1);
  CHECK_THROWS(import_with((folder.path / "b.bin").string()));
  CHECK_THROWS(import_with("file://" + (folder.path / "b.bin").string()));
  CHECK_THROWS(import_with("/dev/zero"));
}

TEST_CASE("external files are not looked for in the current folder") {
  const GltfMaker maker = one_triangle();
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "below");
  const std::string text = maker.gltf("b.bin");
  write_file(folder.path / "t.gltf", text.data(), text.size());
  write_file(folder.path / "below" / "t.gltf", text.data(), text.size());
  write_file(folder.path / "b.bin", maker.buffer.data(), maker.buffer.size());
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path);
  CHECK(cps::import_gltf("t.gltf").meshes.size() == 1);
  CHECK_THROWS_WITH(cps::import_gltf("below/t.gltf"),
                    "below/t.gltf: buffers[0].uri: \"b.bin\" is not beside the glTF file: is it there?");
  std::filesystem::current_path(before);
}

TEST_CASE("a scene has the file's scene name and copyright") {
  GltfMaker maker = one_triangle();
  maker.json["asset"]["copyright"] = "CC0, nobody";
  maker.json["scenes"][0]["name"] = "Karlsruhe";
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.name == "Karlsruhe");
  CHECK(scene.credits == "CC0, nobody");
}

TEST_CASE("missing files, special files and files that are not glTF are refused") {
  const TemporaryFolder folder;
  const std::string name = (folder.path / "scene.glb").string();
  CHECK_THROWS_WITH(cps::import_gltf(name), name + ": no such file");
  CHECK_THROWS_WITH(cps::import_gltf(folder.path), folder.path.string() + ": is not a regular file");
  CHECK_THROWS_WITH(cps::import_gltf("/dev/zero"), "/dev/zero: is not a regular file");
  write_file(name, "", 0);
  CHECK_THROWS_WITH(cps::import_gltf(name), name + ": is empty");

  CHECK_THAT(refusal(bytes_of("hello")), StartsWith("JSON: cannot be parsed"));
  CHECK(refusal(bytes_of("[]")) == "JSON: its root must be an object: is this a glTF file?");
  for (const char* text : {"{}", R"({"asset":[]})", R"({"asset":{"version":2.0}})"})
    CHECK(refusal(bytes_of(text)) == "asset.version: is missing: is this a glTF file?");
  CHECK(refusal(bytes_of(std::string(100000, '['))) ==
        "JSON: nested deeper than 100 levels: is this a glTF file?");
  CHECK(refusal(bytes_of(R"({"asset":{"version":"2.0"}})")) == "scene: holds no triangles to draw");
}

TEST_CASE("a .glb with inconsistent lengths is refused") {
  std::vector<unsigned char> glb = one_triangle().glb();
  const std::size_t size = glb.size();
  SECTION("cut off") {
    glb.resize(size - 1);
    CHECK(refusal(glb) == "GLB header: announces " + std::to_string(size) + " bytes, the file has " +
                              std::to_string(size - 1) + ": is it complete?");
    glb.resize(15);
    CHECK(refusal(glb) == "GLB header: the file ends inside it: is it complete?");
  }
  SECTION("version") {
    put_u32(glb, 4, 1);
    CHECK(refusal(glb) == "GLB header: container version is not 2: convert the file to glTF 2.0");
  }
  SECTION("a chunk longer than the file") {
    put_u32(glb, 12, 0xfffffffc);
    CHECK(refusal(glb) == "GLB chunk: is longer than the file: is it complete?");
  }
  SECTION("a chunk that would end inside the next one's header") {
    // tinygltf leaves the 8 bytes of this header out of its sum and would read past the end.
    const std::size_t json_size = glb[12] + 256 * glb[13];
    put_u32(glb, 20 + json_size, static_cast<std::uint32_t>(size - 20 - json_size));
    CHECK(refusal(glb) == "GLB chunk: is longer than the file: is it complete?");
  }
  SECTION("no JSON") {
    put_u32(glb, 16, 0x004E4942);
    CHECK(refusal(glb) == "GLB chunk: the first one is not JSON: is this a glTF file?");
  }
}

TEST_CASE("unsupported versions and required extensions are refused by name") {
  GltfMaker maker = one_triangle();
  SECTION("glTF 1") {
    maker.json["asset"]["version"] = "1.0";
    CHECK(refusal(maker) == "asset.version: is 1.0, only glTF 2.0 is read: convert the file to 2.0");
  }
  SECTION("minVersion") {
    maker.json["asset"]["minVersion"] = "2.1";
    CHECK(refusal(maker) == "asset.minVersion: is newer than 2.0, only glTF 2.0 is read");
  }
  SECTION("required") {
    maker.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_texture_basisu"};
    CHECK(refusal(maker) ==
          "extensionsRequired: KHR_texture_basisu is not supported: export the file again without it");
  }
  SECTION("used") {
    maker.json["extensionsUsed"] = {"KHR_materials_sheen", "KHR_texture_transform"};
    std::vector<std::string> warnings;
    import_glb(maker, &warnings);
    CHECK(warnings == std::vector<std::string>{"KHR_materials_sheen is not supported and left out"});
  }
}

TEST_CASE("numbers of the wrong kind are refused by their JSON path") {
  GltfMaker maker = one_triangle();
  const auto [pointer, value, line] = GENERATE(table<std::string, nlohmann::json, std::string>({
      {"/accessors/0/byteOffset", -4,
       "accessors[0].byteOffset: does not fit glTF's schema, where "
       "accessors[].byteOffset is a whole number, 0 to 2147483647"},
      {"/nodes/0/mesh", 4294967296,
       "nodes[0].mesh: does not fit glTF's schema, where nodes[].mesh is a whole "
       "number, 0 to 2147483647"},
      {"/meshes/0/primitives/0/attributes/NORMAL", "x",
       "meshes[0].primitives[0].attributes.NORMAL: does not fit glTF's schema, where "
       "meshes[].primitives[].attributes.* is a whole number, 0 to 2147483647"},
      {"/meshes/0/primitives", 7,
       "meshes[0].primitives: does not fit glTF's schema, where "
       "meshes[].primitives[].material is a whole number, 0 to 2147483647"},
      {"/nodes/0/scale", nlohmann::json::array({1, "2", 3}),
       "nodes[0].scale[1]: does not fit glTF's schema, where nodes[].scale[] is a number"},
  }));
  maker.json[nlohmann::json::json_pointer(pointer)] = value;
  CHECK(refusal(maker) == line);
}
