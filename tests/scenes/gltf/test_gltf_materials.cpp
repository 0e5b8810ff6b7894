#include <boost/crc.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/gltf_import.h"
#include "tests/scenes/gltf/gltf_maker.h"

using Catch::Matchers::StartsWith;
using cps::AlphaMode;
using cps::Texture;
using cps::Wrap;
using Eigen::Vector2f;
using nlohmann::json;

namespace {

using Values = std::vector<std::uint8_t>;

GltfMaker textured_square(const std::vector<unsigned char>& image_file) {
  GltfMaker maker = one_square();
  maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
      maker.add_texture(image_file);
  return maker;
}

const Values four_colors = {255, 0, 0, 0, 255, 0, 0, 0, 255, 40, 50, 60};

}  // namespace

TEST_CASE("primitives without a material get the default material") {
  const cps::Scene scene = import_glb(one_triangle());
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].base_color == Eigen::Vector4f(1, 1, 1, 1));
  CHECK(scene.materials[0].metallic == 1);
  CHECK(scene.materials[0].roughness == 1);
  CHECK(scene.materials[0].alpha_mode == AlphaMode::opaque);
  CHECK_FALSE(scene.materials[0].double_sided);
}

TEST_CASE("factors, alpha and emission") {
  GltfMaker maker = one_square();
  maker.json["materials"][0] = {
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0}, {"roughnessFactor", 0.7}}},
      {"emissiveFactor", {1, 0.5, 0}},
      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}},
      {"alphaMode", "MASK"},
      {"alphaCutoff", 0.25},
      {"doubleSided", true}};
  const cps::Material material = import_glb(maker).materials.at(0);
  CHECK(material.base_color == Eigen::Vector4f(0.1f, 0.2f, 0.3f, 0.4f));
  CHECK(material.metallic == 0);
  CHECK(material.roughness == 0.7f);
  CHECK(material.emissive == Eigen::Vector3f(8, 4, 0));
  CHECK(material.alpha_mode == AlphaMode::mask);
  CHECK(material.alpha_cutoff == 0.25f);
  CHECK(material.double_sided);
}

TEST_CASE("factors out of range are clamped with a warning") {
  GltfMaker maker = one_square();
  maker.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 3;
  std::vector<std::string> warnings;
  CHECK(import_glb(maker, &warnings).materials.at(0).roughness == 1);
  CHECK(warnings ==
        std::vector<std::string>{"materials[0].roughnessFactor is out of range, taken as 1.000000"});
}

TEST_CASE("only used materials are kept, each once") {
  GltfMaker maker = one_square();
  maker.json["materials"] = {{{"name", "unused"}}, {{"name", "used"}}};
  maker.primitive()["material"] = 1;
  maker.json["meshes"][0]["primitives"].push_back(maker.primitive());
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].name == "used");
  CHECK(scene.meshes.at(1).material == 0);
}

TEST_CASE("PNG of one to four channels becomes RGBA with unchanged alpha") {
  SECTION("RGB") {
    const Texture texture =
        import_glb(textured_square(encode_image("png", 2, 2, 3, four_colors))).textures.at(0);
    CHECK(texture.width == 2);
    CHECK(texture.height == 2);
    CHECK(texture.rgba == Values{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 40, 50, 60, 255});
    CHECK(texture.srgb);
  }
  SECTION("RGBA") {
    const Values pixels = {200, 100, 50, 0, 200, 100, 50, 128};
    CHECK(import_glb(textured_square(encode_image("png", 2, 1, 4, pixels))).textures.at(0).rgba == pixels);
  }
  SECTION("gray") {
    CHECK(import_glb(textured_square(encode_image("png", 2, 1, 1, {7, 9}))).textures.at(0).rgba ==
          Values{7, 7, 7, 255, 9, 9, 9, 255});
  }
  SECTION("gray and alpha") {
    CHECK(import_glb(textured_square(encode_image("png", 1, 1, 2, {7, 9}))).textures.at(0).rgba ==
          Values{7, 7, 7, 9});
  }
}

TEST_CASE("PNG with a palette, and of 16 bits, in data URIs") {
  GltfMaker maker = textured_square(encode_image("png", 1, 1, 3, {1, 2, 3}));
  // 2 × 1: a palette of (10, 20, 30) and (200, 100, 50) with alpha 255 and 64; gray 0x1234 and 0xff00.
  maker.json["images"][0] = {{"uri",
                              "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAMAAADD/"
                              "I+4AAAABlBMVEUKFB7IZDJ3oLOcAAAAAnRSTlP/"
                              "QJNrcdoAAAAOSURBVHgBAQMA/P8AAAEABAACCyGLcQAAAABJRU5ErkJggg=="}};
  CHECK(import_glb(maker).textures.at(0).rgba == Values{10, 20, 30, 255, 200, 100, 50, 64});
  maker.json["images"][0] = {
      {"uri",
       "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABEAAAAACB2fwVAAAAEElEQVR4AQEFAPr/ABI0/"
       "wAC5wFGE8Kg1AAAAABJRU5ErkJggg=="}};
  CHECK(import_glb(maker).textures.at(0).rgba == Values{0x12, 0x12, 0x12, 255, 0xfe, 0xfe, 0xfe, 255});
}

TEST_CASE("a data URI's media type does not matter") {
  const std::vector<unsigned char> webp = encode_image("webp", 2, 2, 3, Values(12, 100));
  GltfMaker maker = textured_square(encode_image("png", 1, 1, 3, {1, 2, 3}));
  for (const char* header : {"data:image/webp;base64,", "data:;base64,", "data:image/png;name=a;base64,"}) {
    maker.json["images"][0] = {{"uri", header + base64(webp)}};
    CHECK(import_glb(maker).textures.at(0).width == 2);
  }
}

TEST_CASE("JPEG and WebP") {
  const std::string format = GENERATE("jpeg", "webp");
  GltfMaker maker = textured_square(encode_image(format, 16, 16, 3, Values(16 * 16 * 3, 100)));
  if (format == "webp") {
    maker.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    maker.json["extensionsRequired"] = {"EXT_texture_webp"};
  }
  const Texture texture = import_glb(maker).textures.at(0);
  CHECK(texture.width == 16);
  CHECK(std::abs(texture.rgba[4 * 100] - 100) <= 2);
}

TEST_CASE("images from a file and from a data URI") {
  const std::vector<unsigned char> png = encode_image("png", 2, 2, 3, four_colors);
  GltfMaker maker = textured_square(png);
  const Values expected = import_glb(maker).textures.at(0).rgba;
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "Textures");
  write_file(folder.path / "Textures" / "a b.png", png.data(), png.size());
  maker.json["images"][0] = {{"uri", "Textures/a%20b.png"}};
  const std::vector<unsigned char> glb = maker.glb();
  write_file(folder.path / "scene.glb", glb.data(), glb.size());
  const Texture texture = cps::import_gltf(folder.path / "scene.glb").textures.at(0);
  CHECK(texture.rgba == expected);
  CHECK(texture.name == "Textures/a%20b.png");
  CHECK(refusal(maker) ==
        "images[0]: \"Textures/a%20b.png\" cannot be read beside the glTF file: is it there?");
  maker.json["images"][0] = {{"uri", "data:image/png;base64," + base64(png)}};
  CHECK(import_glb(maker).textures.at(0).rgba == expected);
}

TEST_CASE("an image used as colour and as data becomes two textures, used twice as colour one") {
  GltfMaker maker = textured_square(encode_image("png", 1, 1, 3, {1, 2, 3}));
  maker.json["materials"][0]["emissiveTexture"]["index"] = 0;
  maker.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 0;
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.textures.size() == 2);
  const cps::Material& material = scene.materials[0];
  CHECK(material.base_color_texture.texture == material.emissive_texture.texture);
  CHECK(scene.textures[material.base_color_texture.texture].srgb);
  CHECK_FALSE(scene.textures[material.metallic_roughness_texture.texture].srgb);
}

TEST_CASE("samplers give wrap modes and nearest filtering") {
  GltfMaker maker = textured_square(encode_image("png", 1, 1, 3, {1, 2, 3}));
  CHECK(import_glb(maker).textures.at(0).wrap_u == Wrap::repeat);
  CHECK_FALSE(import_glb(maker).textures.at(0).nearest);
  maker.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  maker.json["textures"][0]["sampler"] = 0;
  const Texture texture = import_glb(maker).textures.at(0);
  CHECK(texture.wrap_u == Wrap::clamp_to_edge);
  CHECK(texture.wrap_v == Wrap::mirrored_repeat);
  CHECK(texture.nearest);
  maker.json["samplers"][0]["wrapS"] = 5;
  CHECK(refusal(maker) == "samplers[0].wrapS: wrap mode 5 is not one of glTF's");
}

TEST_CASE("KHR_texture_transform: the extension's example shows the lower left quarter, turned clockwise") {
  GltfMaker maker = textured_square(encode_image("png", 1, 1, 3, {1, 2, 3}));
  maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
            ["KHR_texture_transform"] = {
      {"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}, {"texCoord", 1}};
  const cps::TextureSlot slot = import_glb(maker).materials.at(0).base_color_texture;
  CHECK(slot.uv_set == 1);
  CHECK((slot.uv_transform * Vector2f(0, 0) - Vector2f(0, 1)).norm() < 1e-6f);
  CHECK((slot.uv_transform * Vector2f(1, 0) - Vector2f(0, 0.5f)).norm() < 1e-6f);
  CHECK((slot.uv_transform * Vector2f(0, 1) - Vector2f(0.5f, 1)).norm() < 1e-6f);
}

TEST_CASE("unreadable textures are refused by name") {
  GltfMaker maker = textured_square(encode_image("png", 4, 4, 3, Values(48, 200)));
  const std::string slot = "materials[0].baseColorTexture";
  json& info = maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  SECTION("no such texture") {
    info["index"] = 4;
    CHECK(refusal(maker) == slot + ": texture 4 does not exist");
  }
  SECTION("no such image") {
    maker.json["textures"][0]["source"] = 4;
    CHECK(refusal(maker) == "textures[0].source: image 4 does not exist");
  }
  SECTION("KTX2 alone") {
    maker.json["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    CHECK(refusal(maker) ==
          "textures[0]: has no PNG, JPEG or WebP image (only KHR_texture_basisu): export the textures as PNG "
          "or JPEG");
  }
  SECTION("KTX2 bytes") {
    maker.json["images"][0]["bufferView"] = maker.add_view("\xabKTX 20\xbb\r\n\x1a\n", 12);
    CHECK(refusal(maker) == "images[0]: KTX2 images are not supported: convert to PNG or JPEG");
  }
  SECTION("other bytes") {
    maker.json["images"][0]["bufferView"] = maker.add_view("BM0000000000", 12);
    CHECK(refusal(maker) == "images[0]: is neither PNG, JPEG nor WebP");
  }
  SECTION("cut off") {
    json& view = maker.json["bufferViews"][maker.json["images"][0]["bufferView"].get<int>()];
    view["byteLength"] = 50;
    CHECK(refusal(maker) ==
          "images[0]: png cannot be decoded (chunks or checksums are broken): is the file complete?");
  }
  SECTION("a view beyond the buffer") {
    maker.json["bufferViews"].back()["byteOffset"] = 1000000;
    CHECK_THAT(refusal(maker), StartsWith("bufferViews[4]: reaches beyond its buffer of "));
  }
  SECTION("too large") {
    std::vector<unsigned char> png = encode_image("png", 4, 4, 3, Values(48, 200));
    png[16 + 2] = 0xff;  // in the header chunk's width, big-endian: 4 becomes 65284
    boost::crc_32_type checksum;
    checksum.process_bytes(&png[12], 17);  // type and data of the header chunk
    for (int i = 0; i < 4; ++i) png[29 + i] = static_cast<unsigned char>(checksum.checksum() >> (24 - 8 * i));
    CHECK(refusal(textured_square(png)) == "images[0]: is 65284×4, sides may be 1 to 16384");
  }
  SECTION("alpha mode") {
    maker.json["materials"][0]["alphaMode"] = "GLASS";
    CHECK(refusal(maker) == "materials[0].alphaMode: \"GLASS\" is not OPAQUE, MASK or BLEND");
  }
  SECTION("a transform that is not finite") {
    info["extensions"]["KHR_texture_transform"]["offset"] = {1, "x"};
    CHECK(refusal(maker) == slot + ".KHR_texture_transform.offset: must be 2 finite number(s)");
  }
}
