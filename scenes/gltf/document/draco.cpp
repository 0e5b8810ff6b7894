#include "scenes/gltf/document/draco.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

#include "scenes/gltf/document/accessors.h"

namespace cps::gltf {
namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

int component_type(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return TINYGLTF_COMPONENT_TYPE_BYTE;
    case draco::DT_UINT8:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case draco::DT_INT16:
      return TINYGLTF_COMPONENT_TYPE_SHORT;
    case draco::DT_UINT16:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case draco::DT_UINT32:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    case draco::DT_FLOAT32:
      return TINYGLTF_COMPONENT_TYPE_FLOAT;
    default:
      return -1;
  }
}

/// Checks the sizes in the header, because Draco allocates them before it knows whether so much data follows.
/// Accepts bitstream 2.2 only, as KHR_draco_mesh_compression requires. Takes the buffer by value, which
/// copies its read position but not its bytes.
void check_header(Document& document, draco::DecoderBuffer buffer, const std::string& where) {
  const auto fail = [&](const std::string& why) {
    refuse(document, where, "Draco data cannot be decoded (" + why + ")");
  };
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() ||
      header.encoder_type != draco::TRIANGULAR_MESH)
    fail("it is no Draco mesh");
  if (header.version_major != 2 || header.version_minor != 2)
    fail("its bitstream is " + std::to_string(header.version_major) + "." +
         std::to_string(header.version_minor) + ", glTF's is 2.2");
  draco::GeometryMetadata metadata;
  if ((header.flags & METADATA_FLAG_MASK) != 0 &&
      !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
    fail("its metadata are broken");
  buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
  std::uint8_t traversal = 0;
  std::uint32_t vertices = 0, faces = 0;
  const bool whole = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING
                         ? buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer) &&
                               draco::DecodeVarint(&faces, &buffer)
                         : draco::DecodeVarint(&faces, &buffer) && draco::DecodeVarint(&vertices, &buffer);
  if (!whole) fail("it is cut off");
  constexpr std::size_t decoder_bytes = 64;  // that the decoder's tables take per face or vertex
  reserve_memory(document, where, std::max(vertices, faces), decoder_bytes);
}

std::unique_ptr<draco::Mesh> decode(Document& document, int view, const std::string& where) {
  const std::span<const unsigned char> bytes = bytes_of_view(document, view, 0, where);
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  check_header(document, buffer, where);
  auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    refuse(document, where, "Draco data cannot be decoded (" + decoded.status().error_msg_string() + ")");
  return std::move(decoded).value();
}

/// Adds a buffer of `data`, a view of it and an accessor of `count` elements to the model; returns the
/// accessor's index.
int add_accessor(Document& document, std::vector<unsigned char> data, std::size_t count, int component,
                 int type, bool normalized) {
  tinygltf::Model& model = document.model;
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(model.buffers.size());
  view.byteLength = data.size();
  model.buffers.emplace_back().data = std::move(data);
  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  accessor.count = count;
  accessor.componentType = component;
  accessor.type = type;
  accessor.normalized = normalized;
  model.bufferViews.push_back(std::move(view));
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

int add_indices(Document& document, const draco::Mesh& mesh, const std::string& where) {
  const std::size_t count = std::size_t{3} * mesh.num_faces();
  reserve_memory(document, where, count, sizeof(std::uint32_t));
  std::vector<unsigned char> data(count * sizeof(std::uint32_t));
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t point = mesh.face(draco::FaceIndex(static_cast<std::uint32_t>(i / 3)))[i % 3].value();
    std::memcpy(&data[i * sizeof point], &point, sizeof point);
  }
  return add_accessor(document, std::move(data), count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                      TINYGLTF_TYPE_SCALAR, false);
}

int add_attribute(Document& document, const draco::Mesh& mesh, int id, bool normalized,
                  const std::string& where) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (!attribute) refuse(document, where, "Draco attribute " + std::to_string(id) + " does not exist");
  const int component = component_type(attribute->data_type()), components = attribute->num_components();
  if (component == -1 || components < 1 || components > 4)
    refuse(document, where, "Draco attribute " + std::to_string(id) + " has a type that glTF does not know");
  const std::size_t count = mesh.num_points();
  const std::size_t size =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(component)) * components;
  reserve_memory(document, where, count, size);
  std::vector<unsigned char> data(count * size);
  for (std::size_t i = 0; i < count; ++i) {
    const draco::AttributeValueIndex value =
        attribute->mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    const std::size_t offset =
        attribute->byte_offset() + attribute->byte_stride() * std::size_t{value.value()};
    if (offset > attribute->buffer()->data_size() || size > attribute->buffer()->data_size() - offset)
      refuse(document, where, "Draco data is broken");
    std::memcpy(&data[i * size], attribute->buffer()->data() + offset, size);
  }
  const int type = components == 1 ? TINYGLTF_TYPE_SCALAR : components;  // TINYGLTF_TYPE_VEC2 is 2, and so on
  return add_accessor(document, std::move(data), count, component, type, normalized);
}

}  // namespace

void complete_draco_accessors(nlohmann::json& root) {
  const nlohmann::json::json_pointer view("/extensions/" + std::string(draco_extension) + "/bufferView");
  if (!root.contains("meshes") || !root.contains("accessors")) return;
  nlohmann::json& accessors = root["accessors"];
  for (const auto& mesh : root["meshes"]) {
    if (!mesh.contains("primitives")) continue;
    for (const auto& primitive : mesh["primitives"]) {
      if (!primitive.contains(view) || !primitive.contains("indices")) continue;
      const std::size_t index = primitive["indices"];
      if (index >= accessors.size() || accessors[index].contains("bufferView")) continue;
      accessors[index]["bufferView"] = primitive[view];
    }
  }
}

tinygltf::Primitive without_draco(Document& document, const tinygltf::Primitive& primitive,
                                  const std::string& where) {
  const auto extension = primitive.extensions.find(draco_extension);
  if (extension == primitive.extensions.end()) return primitive;
  const tinygltf::Value& value = extension->second;
  if (!value.Has("bufferView") || !value.Get("bufferView").IsInt() || !value.Has("attributes"))
    refuse(document, where + "." + draco_extension, "must have a bufferView and attributes");
  const std::unique_ptr<draco::Mesh> mesh = decode(document, value.Get("bufferView").GetNumberAsInt(), where);

  tinygltf::Primitive decoded = primitive;
  decoded.mode = TINYGLTF_MODE_TRIANGLES;
  decoded.indices = add_indices(document, *mesh, where);
  const tinygltf::Value& attributes = value.Get("attributes");
  for (const std::string& name : attributes.Keys()) {
    const auto declared = primitive.attributes.find(name);
    if (declared == primitive.attributes.end() || !in_range(declared->second, document.model.accessors) ||
        !attributes.Get(name).IsInt())
      refuse(document, where + "." + name, "Draco attributes must be attributes of their primitive, too");
    const bool normalized = document.model.accessors[declared->second].normalized;
    decoded.attributes[name] =
        add_attribute(document, *mesh, attributes.Get(name).GetNumberAsInt(), normalized, where + "." + name);
  }
  return decoded;
}

}  // namespace cps::gltf
