#include "tests/fuzz/mutate_gltf.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "random/counter_hash.h"

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t max_size);

namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

struct Dice {
  cps::Stream stream;
  std::uint64_t next = 0;
  std::size_t below(std::size_t count) { return cps::random_below(stream, next++, count); }
  template <class T, std::size_t N>
  const T& one_of(const T (&values)[N]) {
    return values[below(N)];
  }
};

struct Parts {
  json root;
  Bytes binary;
  bool glb = false;
};

std::uint32_t little_endian_u32(const unsigned char* from) {
  std::uint32_t value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// The JSON and the binary chunk of a file; `root` is discarded if it is not JSON.
Parts take_apart(std::span<const unsigned char> bytes) {
  Parts parts;
  std::span<const unsigned char> text = bytes;
  if (bytes.size() >= 20 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
    parts.glb = true;
    const std::size_t json_size = std::min<std::size_t>(little_endian_u32(&bytes[12]), bytes.size() - 20);
    text = bytes.subspan(20, json_size);
    if (bytes.size() >= 28 + json_size) parts.binary.assign(bytes.begin() + 28 + json_size, bytes.end());
  }
  parts.root = json::parse(text.begin(), text.end(), nullptr, false);
  return parts;
}

Bytes put_together(const Parts& parts) {
  std::string text = parts.root.dump(-1, ' ', false, json::error_handler_t::replace);
  if (!parts.glb) return {text.begin(), text.end()};
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t padded = (parts.binary.size() + 3) / 4 * 4;
  Bytes bytes;
  for (const std::size_t value :
       {std::size_t{0x46546C67}, std::size_t{2}, 12 + 8 + text.size() + (padded ? 8 + padded : 0),
        text.size(), std::size_t{0x4E4F534A}})
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(value >> shift));
  bytes.insert(bytes.end(), text.begin(), text.end());
  if (!padded) return bytes;
  for (const std::size_t value : {padded, std::size_t{0x004E4942}})
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(value >> shift));
  bytes.insert(bytes.end(), parts.binary.begin(), parts.binary.end());
  bytes.resize(bytes.size() + padded - parts.binary.size());
  return bytes;
}

void collect(json& value, std::vector<json*>& all) {
  all.push_back(&value);
  if (value.is_structured())
    for (json& child : value) collect(child, all);
}

json any_number(Dice& dice) {
  constexpr double numbers[] = {
      0,    1,     2,     3,   4,   7,   255,          256, 5120, 5121, 5122, 5123,         5125,
      5126, 65535, 65536, 1e6, 1e8, 1e9, 2147483647.0, -1,  -0.5, 0.5,  1e-9, 4294967295.0, 1e18,
      1e38, 1e300, 33071, 9728};
  const double number = dice.one_of(numbers);
  const auto whole = static_cast<std::int64_t>(std::min(number, 1e18));
  return number == static_cast<double>(whole) ? json(whole) : json(number);
}

/// Property names and values that the importer reads.
constexpr const char* words[] = {"SCALAR",
                                 "VEC2",
                                 "VEC3",
                                 "VEC4",
                                 "MAT2",
                                 "MAT4",
                                 "OPAQUE",
                                 "MASK",
                                 "BLEND",
                                 "POSITION",
                                 "NORMAL",
                                 "TANGENT",
                                 "TEXCOORD_0",
                                 "TEXCOORD_1",
                                 "COLOR_0",
                                 "JOINTS_0",
                                 "WEIGHTS_0",
                                 "TRANSLATION",
                                 "ROTATION",
                                 "SCALE",
                                 "scene.glb",
                                 "../scene.glb",
                                 "/dev/zero",
                                 "data:image/png;base64,iVBORw0KGgo=",
                                 "data:application/octet-stream;base64,AAAA",
                                 "image/png",
                                 "bufferView",
                                 "byteOffset",
                                 "byteLength",
                                 "byteStride",
                                 "count",
                                 "componentType",
                                 "normalized",
                                 "type",
                                 "sparse",
                                 "indices",
                                 "values",
                                 "mesh",
                                 "skin",
                                 "children",
                                 "matrix",
                                 "translation",
                                 "rotation",
                                 "scale",
                                 "mode",
                                 "material",
                                 "targets",
                                 "extensions",
                                 "extras",
                                 "uri",
                                 "index",
                                 "texCoord",
                                 "source",
                                 "sampler",
                                 "joints",
                                 "inverseBindMatrices",
                                 "alphaMode",
                                 "attributes",
                                 "doubleSided",
                                 "primitives",
                                 "buffers",
                                 "images",
                                 "textures",
                                 "KHR_texture_transform",
                                 "KHR_draco_mesh_compression",
                                 "EXT_mesh_gpu_instancing",
                                 "KHR_materials_emissive_strength",
                                 "EXT_texture_webp"};

void mutate_value(Dice& dice, json& value, const std::vector<json*>& all) {
  switch (dice.below(8)) {
    case 0:
    case 1:
    case 2:
      if (value.is_number_integer() && dice.below(2) == 0)
        value = value.get<std::int64_t>() + static_cast<std::int64_t>(dice.below(9)) - 4;
      else if (value.is_string())
        value = dice.one_of(words);
      else if (value.is_boolean())
        value = !value.get<bool>();
      else if (!value.is_structured())
        value = any_number(dice);
      break;
    case 3: {
      const json copy = *all[dice.below(all.size())];
      if (copy.dump().size() < 2000) value = copy;
      break;
    }
    case 4:
      if (value.is_structured() && !value.empty()) {
        auto child = value.begin();
        std::advance(child, dice.below(value.size()));
        value.erase(child);
      }
      break;
    case 5:
      if (value.is_array() && !value.empty()) value.push_back(json(value[dice.below(value.size())]));
      break;
    case 6:
      if (value.is_object()) {
        const json copy = *all[dice.below(all.size())];
        if (copy.dump().size() < 2000) value[dice.one_of(words)] = copy;
      }
      break;
    default:
      if (value.is_object()) value[dice.one_of(words)] = any_number(dice);
      if (value.is_array()) value.push_back(any_number(dice));
  }
}

void mutate_binary(Dice& dice, Bytes& binary) {
  const std::size_t at = dice.below(binary.size());
  const std::size_t length = std::min<std::size_t>(1 + dice.below(64), binary.size() - at);
  Bytes part(binary.begin() + at, binary.begin() + at + length);
  part.resize(LLVMFuzzerMutate(part.data(), length, length));
  std::copy(part.begin(), part.end(), binary.begin() + at);
}

void repair_png_checksums(Bytes& bytes) {
  constexpr unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  const auto big_endian_u32 = [&](std::size_t at) {
    return std::uint32_t{bytes[at]} << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
  };
  auto found = bytes.begin();
  while (true) {
    found = std::search(found, bytes.end(), std::begin(signature), std::end(signature));
    if (found == bytes.end()) return;
    found += sizeof signature;
    for (std::size_t at = found - bytes.begin(); at + 12 <= bytes.size();) {
      const std::size_t length = big_endian_u32(at);
      if (length > bytes.size() - at - 12) break;
      boost::crc_32_type checksum;
      checksum.process_bytes(&bytes[at + 4], length + 4);
      for (int i = 0; i < 4; ++i)
        bytes[at + 8 + length + i] = static_cast<unsigned char>(checksum.checksum() >> (24 - 8 * i));
      at += 12 + length;
    }
  }
}

}  // namespace

std::size_t mutate_gltf(unsigned char* bytes, std::size_t size, std::size_t max_size, unsigned int seed) {
  Dice dice{cps::make_stream(seed, "mutate glTF")};
  Parts parts = take_apart({bytes, size});
  if (dice.below(8) == 0 || parts.root.is_discarded()) return LLVMFuzzerMutate(bytes, size, max_size);
  for (std::size_t left = 1 + dice.below(3); left > 0; --left) {
    if (!parts.binary.empty() && dice.below(3) == 0) {
      mutate_binary(dice, parts.binary);
      if (dice.below(4) != 0) repair_png_checksums(parts.binary);
    } else {
      std::vector<json*> all;
      collect(parts.root, all);
      mutate_value(dice, *all[dice.below(all.size())], all);
    }
  }
  const Bytes changed = put_together(parts);
  if (changed.size() > max_size) return size;
  std::copy(changed.begin(), changed.end(), bytes);
  return changed.size();
}
