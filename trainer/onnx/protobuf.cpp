#include "trainer/onnx/protobuf.h"

#include <bit>

namespace cps {
namespace {

enum class WireType { varint = 0, length_delimited = 2, fixed32 = 5 };

/// Seven bits a byte, the low ones first; the top bit says that more follow.
void put_varint(std::string& message, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) message += static_cast<char>((value & 0x7f) | 0x80);
  message += static_cast<char>(value);
}

void put_tag(std::string& message, int field, WireType type) {
  put_varint(message, static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(type));
}

}  // namespace

void put_integer_field(std::string& message, int field, std::int64_t value) {
  put_tag(message, field, WireType::varint);
  put_varint(message, static_cast<std::uint64_t>(value));
}

void put_float_field(std::string& message, int field, float value) {
  put_tag(message, field, WireType::fixed32);
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i) message += static_cast<char>(bits >> 8 * i & 0xff);
}

void put_bytes_field(std::string& message, int field, std::string_view bytes) {
  put_tag(message, field, WireType::length_delimited);
  put_varint(message, bytes.size());
  message += bytes;
}

}  // namespace cps
