#include "tests/scenes/gltf/gltf_maker.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "scenes/gltf_import.h"

int GltfMaker::add_view(const void* data, std::size_t size, std::size_t stride) {
  buffer.resize((buffer.size() + 3) / 4 * 4);
  auto& views = json["bufferViews"];
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}};
  if (stride) view["byteStride"] = stride;
  views.push_back(view);
  const auto* bytes = static_cast<const unsigned char*>(data);
  buffer.insert(buffer.end(), bytes, bytes + size);
  return static_cast<int>(views.size()) - 1;
}

int GltfMaker::add_accessor(int view, int component, const char* type, std::size_t count, bool normalized) {
  nlohmann::json accessor = {
      {"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}};
  if (normalized) accessor["normalized"] = true;
  json["accessors"].push_back(accessor);
  return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfMaker::add_floats(const std::vector<float>& values, const char* type) {
  const std::size_t components = type[0] == 'V' ? type[3] - '0' : type[0] == 'M' ? 16 : 1;
  return add(values, 5126, type, values.size() / components);
}

int GltfMaker::add_texture(const std::vector<unsigned char>& image_file) {
  const int view = add_view(image_file.data(), image_file.size());
  json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  json["textures"].push_back({{"source", json["images"].size() - 1}});
  return static_cast<int>(json["textures"].size()) - 1;
}

std::vector<unsigned char> GltfMaker::glb() const {
  nlohmann::json root = json;
  if (!buffer.empty() && !root.contains("buffers")) root["buffers"] = {{{"byteLength", buffer.size()}}};
  std::string text = root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::vector<unsigned char> bytes;
  const auto put_u32 = [&](std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(value >> shift));
  };
  const std::size_t padded = (buffer.size() + 3) / 4 * 4;
  put_u32(0x46546C67);
  put_u32(2);
  put_u32(12 + 8 + text.size() + (padded ? 8 + padded : 0));
  put_u32(text.size());
  put_u32(0x4E4F534A);
  bytes.insert(bytes.end(), text.begin(), text.end());
  if (padded) {
    put_u32(padded);
    put_u32(0x004E4942);
    bytes.insert(bytes.end(), buffer.begin(), buffer.end());
    bytes.resize(bytes.size() + padded - buffer.size());
  }
  return bytes;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned int b = i + 1 < bytes.size() ? bytes[i + 1] : 0,
                       c = i + 2 < bytes.size() ? bytes[i + 2] : 0;
    const unsigned int group = bytes[i] << 16 | b << 8 | c;
    text += digits[group >> 18];
    text += digits[group >> 12 & 63];
    text += i + 1 < bytes.size() ? digits[group >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? digits[group & 63] : '=';
  }
  return text;
}

std::string GltfMaker::gltf(const std::string& uri) const {
  nlohmann::json root = json;
  root["buffers"] = {{{"byteLength", buffer.size()},
                      {"uri", uri.empty() ? "data:application/octet-stream;base64," + base64(buffer) : uri}}};
  return root.dump();
}

GltfMaker one_triangle() {
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  maker.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}}};
  maker.json["nodes"] = {{{"mesh", 0}}};
  maker.json["scenes"] = {{{"nodes", {0}}}};
  maker.json["scene"] = 0;
  return maker;
}

GltfMaker one_square() {
  GltfMaker maker;
  const int positions = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
  const int normals = maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int uv = maker.add_floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
  const int indices = maker.add(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 6);
  maker.json["materials"] = {{{"name", "plain"}}};
  maker.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
          {"indices", indices},
          {"material", 0}}}}}};
  maker.json["nodes"] = {{{"mesh", 0}}};
  maker.json["scenes"] = {{{"nodes", {0}}}};
  maker.json["scene"] = 0;
  return maker;
}

GltfMaker skinned_triangle() {
  GltfMaker maker = one_triangle();
  const double half = std::sqrt(0.5);
  const int binds = maker.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4, 0, 0, 1,  //
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1},
                                     "MAT4");
  maker.primitive()["attributes"]["JOINTS_0"] =
      maker.add(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4", 3);
  maker.primitive()["attributes"]["WEIGHTS_0"] =
      maker.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
  maker.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}};
  maker.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                         {{"translation", {10, 0, 0}}},
                         {{"rotation", {0, 0, half, half}}}};
  maker.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
  return maker;
}

std::vector<unsigned char> encode_image(const std::string& format, int width, int height, int channels,
                                        const std::vector<std::uint8_t>& values) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(format);
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  output->set_ioproxy(&memory);
  if (!output->open("memory." + format, spec) || !output->write_image(OIIO::TypeDesc::UINT8, values.data()) ||
      !output->close())
    throw std::runtime_error(output->geterror());
  return bytes;
}

void write_file(const std::filesystem::path& file, const void* data, std::size_t size) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

cps::Scene import_bytes(const std::vector<unsigned char>& bytes, std::vector<std::string>* warnings) {
  const TemporaryFolder folder;
  write_file(folder.path / "scene.glb", bytes.data(), bytes.size());
  cps::Scene scene = cps::import_gltf(folder.path / "scene.glb");
  if (warnings) *warnings = scene.import_warnings;
  return scene;
}

cps::Scene import_glb(const GltfMaker& maker, std::vector<std::string>* warnings) {
  return import_bytes(maker.glb(), warnings);
}

std::string refusal(const std::vector<unsigned char>& bytes) {
  try {
    import_bytes(bytes);
  } catch (const std::runtime_error& error) {
    const std::string line = error.what(), name = "scene.glb: ";
    return line.substr(line.find(name) + name.size());
  }
  return "";
}

std::string refusal(const GltfMaker& maker) {
  return refusal(maker.glb());
}
