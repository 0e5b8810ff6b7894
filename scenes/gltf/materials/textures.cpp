#include "scenes/gltf/materials/textures.h"

#include <cmath>

#include "scenes/gltf/materials/factors.h"
#include "scenes/gltf/materials/images.h"

namespace cps::gltf {
namespace {

Wrap wrap_mode(const Document& document, int mode, const std::string& where) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clamp_to_edge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirrored_repeat;
  }
  refuse(document, where, "wrap mode " + std::to_string(mode) + " is not one of glTF's");
}

/// The image of a glTF texture; the one in EXT_texture_webp if there is no other.
int image_of(const Document& document, int texture_index, const std::string& where) {
  if (!in_range(texture_index, document.model.textures))
    refuse(document, where, "texture " + std::to_string(texture_index) + " does not exist");
  const tinygltf::Texture& texture = document.model.textures[texture_index];
  const std::string name = element("textures", texture_index);
  int image = texture.source;
  if (const auto webp = texture.extensions.find("EXT_texture_webp");
      image == -1 && webp != texture.extensions.end() && webp->second.Get("source").IsInt())
    image = webp->second.Get("source").GetNumberAsInt();
  if (image == -1) {
    const std::string extension =
        texture.extensions.empty() ? "" : " (only " + texture.extensions.begin()->first + ")";
    refuse(document, name,
           "has no PNG, JPEG or WebP image" + extension + ": export the textures as PNG or JPEG");
  }
  if (!in_range(image, document.model.images))
    refuse(document, name + ".source", "image " + std::to_string(image) + " does not exist");
  return image;
}

Texture make_texture(Document& document, int image, int sampler_index, bool srgb) {
  DecodedImage decoded = decode_image(document, image);
  Texture texture;
  const tinygltf::Image& source = document.model.images[image];
  texture.name = source.name.empty() ? source.uri : source.name;
  texture.width = decoded.width;
  texture.height = decoded.height;
  texture.rgba = std::move(decoded.rgba);
  texture.srgb = srgb;
  if (sampler_index != -1) {
    const std::string where = element("samplers", sampler_index);
    if (!in_range(sampler_index, document.model.samplers)) refuse(document, where, "does not exist");
    const tinygltf::Sampler& sampler = document.model.samplers[sampler_index];
    texture.wrap_u = wrap_mode(document, sampler.wrapS, where + ".wrapS");
    texture.wrap_v = wrap_mode(document, sampler.wrapT, where + ".wrapT");
    texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  return texture;
}

}  // namespace

TextureSlot texture_slot(MaterialTable& table, int index, int uv_set,
                         const tinygltf::ExtensionMap& extensions, bool srgb, const std::string& where) {
  TextureSlot slot;
  if (index == -1) return slot;
  Document& document = table.document;
  const int image = image_of(document, index, where);
  const int sampler = document.model.textures[index].sampler;
  const auto [found, is_new] = table.textures.try_emplace({image, sampler, srgb}, -1);
  if (is_new) {
    table.scene.textures.push_back(make_texture(document, image, sampler, srgb));
    found->second = static_cast<int>(table.scene.textures.size()) - 1;
  }
  slot.texture = found->second;
  slot.uv_set = uv_set;

  if (const auto found_transform = extensions.find("KHR_texture_transform");
      found_transform != extensions.end()) {
    const tinygltf::Value& transform = found_transform->second;
    const std::string name = where + ".KHR_texture_transform";
    const auto offset = extension_numbers(document, transform, "offset", {0, 0}, name);
    const auto scale = extension_numbers(document, transform, "scale", {1, 1}, name);
    const double rotation = extension_numbers(document, transform, "rotation", {0}, name)[0];
    if (transform.Has("texCoord") && transform.Get("texCoord").IsInt())
      slot.uv_set = transform.Get("texCoord").GetNumberAsInt();
    // The rotation is anticlockwise with v pointing down, as in the extension's example and in all viewers;
    // the GLSL code in its text turns the other way (KhronosGroup/glTF, issue 1563).
    slot.uv_transform = Eigen::Translation2d(offset[0], offset[1]).cast<float>() *
                        Eigen::Rotation2Dd(-rotation).cast<float>() *
                        Eigen::Scaling(static_cast<float>(scale[0]), static_cast<float>(scale[1]));
  }
  if (slot.uv_set < 0) refuse(document, where, "uses TEXCOORD_" + std::to_string(slot.uv_set));
  return slot;
}

TextureSlot extension_texture(MaterialTable& table, const tinygltf::Value& extension, const char* key,
                              bool srgb, const std::string& where) {
  if (!extension.IsObject() || !extension.Has(key)) return {};
  const tinygltf::Value& info = extension.Get(key);
  const std::string name = where + "." + key;
  const auto whole_number = [&](const char* member, int missing) {
    if (!info.IsObject() || !info.Has(member)) return missing;
    if (!info.Get(member).IsInt()) refuse(table.document, name + "." + member, "must be a whole number");
    return info.Get(member).GetNumberAsInt();
  };
  const int index = whole_number("index", -1);
  if (index < 0) refuse(table.document, name, "names no texture");
  tinygltf::ExtensionMap extensions;
  if (info.Has("extensions") && info.Get("extensions").IsObject())
    extensions = info.Get("extensions").Get<tinygltf::Value::Object>();
  return texture_slot(table, index, whole_number("texCoord", 0), extensions, srgb, name);
}

}  // namespace cps::gltf
