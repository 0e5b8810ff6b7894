#include <catch2/catch.hpp>

#include "trainer/onnx/protobuf.h"

using namespace cps;
using namespace std::string_literals;

namespace {

std::string integer(int field, std::int64_t value) {
  std::string message;
  put_integer_field(message, field, value);
  return message;
}

std::string text(int field, std::string_view value) {
  std::string message;
  put_bytes_field(message, field, value);
  return message;
}

std::string real(int field, float value) {
  std::string message;
  put_float_field(message, field, value);
  return message;
}

}  // namespace

// The first three are the examples of protobuf's own description of its encoding.
TEST_CASE("fields have the bytes that protobuf's description gives") {
  CHECK(integer(1, 150) == "\x08\x96\x01");
  CHECK(text(2, "testing") == "\x12\x07testing");
  CHECK(text(3, integer(1, 150)) == "\x1a\x03\x08\x96\x01");
  CHECK(integer(1, 0) == "\x08\x00"s);
  CHECK(integer(1, 127) == "\x08\x7f");
  CHECK(integer(1, 128) == "\x08\x80\x01");
  CHECK(integer(1, 300) == "\x08\xac\x02");
  CHECK(text(1, "") == "\x0a\x00"s);
  CHECK(text(1, "\0"s) == "\x0a\x01\x00"s);
}

TEST_CASE("field numbers above 15 take two bytes, negative numbers ten, floats four") {
  CHECK(integer(15, 1) == "\x78\x01");
  CHECK(integer(16, 1) == "\x80\x01\x01");
  CHECK(integer(20, 7) == "\xa0\x01\x07");
  CHECK(integer(1, -1) == "\x08\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01");
  CHECK(integer(1, std::numeric_limits<std::int64_t>::max()) == "\x08\xff\xff\xff\xff\xff\xff\xff\xff\x7f");
  CHECK(real(2, 1) == "\x15\x00\x00\x80\x3f"s);
  CHECK(real(2, -0.f) == "\x15\x00\x00\x00\x80"s);
  CHECK(text(1, std::string(200, 'a')).substr(0, 3) == "\x0a\xc8\x01");
}

TEST_CASE("fields follow one another in the order of the calls") {
  std::string message;
  put_bytes_field(message, 2, "b");
  put_integer_field(message, 1, 1);
  put_integer_field(message, 1, 2);
  CHECK(message ==
        "\x12\x01"
        "b\x08\x01\x08\x02");
}
