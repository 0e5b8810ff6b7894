#include "scenes/gltf/document/meshopt.h"

#include <meshoptimizer.h>

#include "scenes/gltf/document/accessors.h"

namespace cps::gltf {
namespace {

constexpr const char* meshopt_extension = "EXT_meshopt_compression";

/// The extension's JSON object in a buffer view.
struct CompressedView {
  Document& document;
  const tinygltf::Value& value;
  std::string where;

  std::size_t whole_number(const char* key, std::size_t missing) const {
    if (!value.IsObject() || !value.Has(key)) return missing;
    const tinygltf::Value& number = value.Get(key);
    if (!number.IsInt() || number.GetNumberAsInt() < 0)
      refuse(document, where + "." + key, "must be a whole number, at least 0");
    return static_cast<std::size_t>(number.GetNumberAsInt());
  }
  std::string word(const char* key, const char* missing) const {
    if (!value.IsObject() || !value.Has(key) || !value.Get(key).IsString()) return missing;
    return value.Get(key).Get<std::string>();
  }
};

std::span<const unsigned char> compressed_bytes(const CompressedView& view) {
  const auto buffer = static_cast<int>(view.whole_number("buffer", 0));
  if (!in_range(buffer, view.document.model.buffers))
    refuse(view.document, view.where + ".buffer", std::to_string(buffer) + " does not exist");
  const std::vector<unsigned char>& data = view.document.model.buffers[buffer].data;
  const std::size_t offset = view.whole_number("byteOffset", 0), length = view.whole_number("byteLength", 0);
  if (offset > data.size() || length > data.size() - offset)
    refuse(view.document, view.where,
           "reaches beyond its buffer of " + std::to_string(data.size()) + " bytes");
  return std::span(data).subspan(offset, length);
}

/// Undoes the filter. Strides as the extension demands them; others would write beyond the elements.
void apply_filter(const CompressedView& view, std::vector<unsigned char>& data, std::size_t count,
                  std::size_t stride) {
  const std::string filter = view.word("filter", "NONE");
  if (filter == "NONE") return;
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    return meshopt_decodeFilterOct(data.data(), count, stride);
  if (filter == "QUATERNION" && stride == 8) return meshopt_decodeFilterQuat(data.data(), count, stride);
  if (filter == "EXPONENTIAL" && stride % 4 == 0) return meshopt_decodeFilterExp(data.data(), count, stride);
  refuse(view.document, view.where + ".filter",
         filter + " with a byteStride of " + std::to_string(stride) + " is not one of the extension's");
}

std::vector<unsigned char> decoded(const CompressedView& view) {
  const std::span<const unsigned char> bytes = compressed_bytes(view);
  const std::size_t count = view.whole_number("count", 0), stride = view.whole_number("byteStride", 0);
  const std::string mode = view.word("mode", "");
  constexpr std::size_t max_stride = 256;  // meshoptimizer's
  const bool is_vertex_stride = stride > 0 && stride <= max_stride && stride % 4 == 0,
             is_index_stride = stride == 2 || stride == 4;
  reserve_memory(view.document, view.where, count, stride);
  std::vector<unsigned char> data(count * stride);
  int error = 1;
  if (mode == "ATTRIBUTES" && is_vertex_stride)
    error = meshopt_decodeVertexBuffer(data.data(), count, stride, bytes.data(), bytes.size());
  else if (mode == "TRIANGLES" && is_index_stride && count % 3 == 0)
    error = meshopt_decodeIndexBuffer(data.data(), count, stride, bytes.data(), bytes.size());
  else if (mode == "INDICES" && is_index_stride)
    error = meshopt_decodeIndexSequence(data.data(), count, stride, bytes.data(), bytes.size());
  else
    refuse(view.document, view.where, "its mode, byteStride and count do not go together");
  if (error != 0) refuse(view.document, view.where, "its data is broken: is the file complete?");
  apply_filter(view, data, count, stride);
  return data;
}

}  // namespace

void complete_meshopt_buffers(nlohmann::json& root) {
  const nlohmann::json::json_pointer extension("/extensions/" + std::string(meshopt_extension));
  if (!root.contains("buffers") || !root["buffers"].is_array()) return;
  for (nlohmann::json& buffer : root["buffers"])
    if (buffer.is_object() && buffer.contains(extension))
      buffer = {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}};
}

void decode_meshopt_views(Document& document) {
  for (std::size_t i = 0; i < document.model.bufferViews.size(); ++i) {
    tinygltf::BufferView& view = document.model.bufferViews[i];
    const auto extension = view.extensions.find(meshopt_extension);
    if (extension == view.extensions.end()) continue;
    tinygltf::Buffer buffer;
    buffer.data = decoded({document, extension->second, element("bufferViews", i) + "." + meshopt_extension});
    document.model.buffers.push_back(std::move(buffer));
    view.buffer = static_cast<int>(document.model.buffers.size()) - 1;
    view.byteOffset = 0;
    view.byteLength = document.model.buffers.back().data.size();
  }
}

}  // namespace cps::gltf
