#include "scenes/gltf/document/accessors.h"

#include <algorithm>
#include <cstring>

namespace cps::gltf {
namespace {

using Bytes = std::span<const unsigned char>;

void check_fit(const Document& document, Bytes bytes, std::size_t count, std::size_t stride,
               std::size_t element_size, const std::string& where) {
  if (bytes.size() < element_size || count - 1 > (bytes.size() - element_size) / stride)
    refuse(document, where, std::to_string(count) + " elements reach beyond the buffer view");
}

template <class T>
T load(const unsigned char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

std::uint32_t whole_number(const Elements& from, std::size_t i) {
  const unsigned char* data = from.data + i * from.stride;
  switch (from.component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *data;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(data);
    default:
      return load<std::uint32_t>(data);
  }
}

bool is_index_type(const Elements& from) {
  return from.components == 1 && (from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                  from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                  from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

/// Replaces the elements that a sparse accessor names, at strictly increasing indices (glTF 2.0 §3.6.2.3).
void replace_sparse(Document& document, const tinygltf::Accessor& accessor, Elements& dense,
                    const std::string& where) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > dense.count ||
      sparse.values.byteOffset < 0 || sparse.indices.byteOffset < 0)
    refuse(document, where, "sparse count or offset is out of range");
  const auto count = static_cast<std::size_t>(sparse.count);

  Elements indices{.count = count, .components = 1, .component_type = sparse.indices.componentType};
  if (!is_index_type(indices)) refuse(document, where, "sparse indices must be u8, u16 or u32");
  indices.stride = tinygltf::GetComponentSizeInBytes(sparse.indices.componentType);
  const Bytes index_bytes =
      bytes_of_view(document, sparse.indices.bufferView, sparse.indices.byteOffset, where);
  check_fit(document, index_bytes, count, indices.stride, indices.stride, where);
  indices.data = index_bytes.data();

  const Bytes values = bytes_of_view(document, sparse.values.bufferView, sparse.values.byteOffset, where);
  check_fit(document, values, count, dense.stride, dense.stride, where);

  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t target = whole_number(indices, i);
    if (target >= dense.count || (i > 0 && target <= whole_number(indices, i - 1)))
      refuse(document, where, "sparse indices must increase and stay below the accessor's count");
    std::memcpy(dense.owned.data() + target * dense.stride, values.data() + i * dense.stride, dense.stride);
  }
}

}  // namespace

std::span<const unsigned char> bytes_of_view(const Document& document, int view_index, std::size_t offset,
                                             const std::string& where) {
  const tinygltf::Model& model = document.model;
  if (!in_range(view_index, model.bufferViews))
    refuse(document, where, "buffer view " + std::to_string(view_index) + " does not exist");
  const tinygltf::BufferView& view = model.bufferViews[view_index];
  const std::string name = element("bufferViews", view_index);
  if (!in_range(view.buffer, model.buffers))
    refuse(document, name + ".buffer", std::to_string(view.buffer) + " does not exist");
  const std::vector<unsigned char>& buffer = model.buffers[view.buffer].data;
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    refuse(document, name, "reaches beyond its buffer of " + std::to_string(buffer.size()) + " bytes");
  if (offset > view.byteLength)
    refuse(document, where, "starts beyond " + name + " of " + std::to_string(view.byteLength) + " bytes");
  return std::span(buffer).subspan(view.byteOffset + offset, view.byteLength - offset);
}

Elements elements(Document& document, int index, const std::string& where) {
  if (!in_range(index, document.model.accessors))
    refuse(document, where, "accessor " + std::to_string(index) + " does not exist");
  const tinygltf::Accessor& accessor = document.model.accessors[index];
  const std::string name = where + " (accessors[" + std::to_string(index) + "])";
  const int component_size = tinygltf::GetComponentSizeInBytes(accessor.componentType);
  const int components = tinygltf::GetNumComponentsInType(accessor.type);
  const bool known = component_size > 0 && components > 0 &&
                     accessor.componentType != TINYGLTF_COMPONENT_TYPE_DOUBLE &&
                     accessor.componentType != TINYGLTF_COMPONENT_TYPE_INT;
  if (!known) refuse(document, name, "componentType or type is not one of glTF's");
  if (accessor.count == 0) refuse(document, name, "has no elements");

  const auto element_size = static_cast<std::size_t>(component_size) * components;
  Elements result{.count = accessor.count,
                  .stride = element_size,
                  .components = components,
                  .component_type = accessor.componentType,
                  .normalized = accessor.normalized};
  if (accessor.bufferView != -1) {
    const Bytes bytes = bytes_of_view(document, accessor.bufferView, accessor.byteOffset, name);
    const std::size_t stride = document.model.bufferViews[accessor.bufferView].byteStride;
    if (stride != 0) result.stride = stride;
    if (result.stride < element_size) refuse(document, name, "byteStride is smaller than one element");
    check_fit(document, bytes, result.count, result.stride, element_size, name);
    result.data = bytes.data();
    if (!accessor.sparse.isSparse) return result;
  }

  reserve_memory(document, name, result.count, element_size);
  result.owned.assign(result.count * element_size, 0);
  if (result.data)
    for (std::size_t i = 0; i < result.count; ++i)
      std::memcpy(result.owned.data() + i * element_size, result.data + i * result.stride, element_size);
  result.stride = element_size;
  if (accessor.sparse.isSparse) replace_sparse(document, accessor, result, name);
  result.data = result.owned.data();
  return result;
}

float component(const Elements& from, std::size_t i, int c) {
  const unsigned char* data = from.data + i * from.stride;
  switch (from.component_type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return load<float>(data + 4 * c);
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const float value = static_cast<std::int8_t>(data[c]);
      return from.normalized ? std::max(value / 127.0f, -1.0f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return from.normalized ? data[c] / 255.0f : data[c];
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const float value = load<std::int16_t>(data + 2 * c);
      return from.normalized ? std::max(value / 32767.0f, -1.0f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const float value = load<std::uint16_t>(data + 2 * c);
      return from.normalized ? value / 65535.0f : value;
    }
    default:
      return static_cast<float>(load<std::uint32_t>(data + 4 * c));
  }
}

std::vector<std::uint32_t> read_indices(Document& document, int accessor, const std::string& where) {
  const Elements from = elements(document, accessor, where);
  if (!is_index_type(from)) refuse(document, where, "indices must be u8, u16 or u32 scalars");
  reserve_memory(document, where, from.count, sizeof(std::uint32_t));
  std::vector<std::uint32_t> indices(from.count);
  const std::size_t bits = 8 * tinygltf::GetComponentSizeInBytes(from.component_type);
  const auto restart = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);  // glTF 2.0 §3.7.2.1
  for (std::size_t i = 0; i < from.count; ++i) {
    indices[i] = whole_number(from, i);
    if (indices[i] == restart)
      refuse(document, where, std::to_string(restart) + " restarts primitives, which glTF does not have");
  }
  return indices;
}

}  // namespace cps::gltf
