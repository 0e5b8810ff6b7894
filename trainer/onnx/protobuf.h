#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Writes messages in protobuf's wire format (protobuf.dev, "Encoding"). Google's library is not used: an
/// upstream LibTorch brings a copy of its own, which must not meet a second one in a program, and its
/// releases need not agree in every byte.
namespace cps {

/// Appends a field of type int32, int64 or enum to a message.
void put_integer_field(std::string& message, int field, std::int64_t value);

/// Appends a field of type float.
void put_float_field(std::string& message, int field, float value);

/// Appends a field of type string or bytes, or another message.
void put_bytes_field(std::string& message, int field, std::string_view bytes);

}  // namespace cps
