#include <catch2/catch.hpp>
#include <limits>

#include "trainer/network/pickle.h"

using namespace cps;

namespace {

std::int64_t integer(const std::string& pickle) {
  return std::get<std::int64_t>(read_pickle(pickle)->scalar);
}

/// The object of Python's pickle.dumps(value, 2) for a whole number that it writes as LONG1: so many bytes of
/// two's complement, the lowest first.
std::int64_t long1(const std::string& bytes) {
  return integer("\x80\x02\x8a" + std::string(1, static_cast<char>(bytes.size())) + bytes + ".");
}

}  // namespace

TEST_CASE("whole numbers of every length keep their sign") {
  using namespace std::string_literals;
  CHECK(long1("") == 0);
  CHECK(long1("\x7f") == 127);
  CHECK(long1("\xff") == -1);
  CHECK(long1("\x80") == -128);
  CHECK(long1("\xff\x00"s) == 255);
  CHECK(long1("\x00\x80"s) == -32768);
  CHECK(long1("\xc7\xcf\xff") == -12345);
  CHECK(long1("\x00\x00\x00\x00\xff"s) == -(std::int64_t{1} << 32));
  CHECK(long1("\x00\x00\x00\x00\x00\x00\x80"s) == -(std::int64_t{1} << 55));
  CHECK(long1("\x00\x00\x00\x00\x00\x00\x00\x80"s) == std::numeric_limits<std::int64_t>::min());
  CHECK(long1("\xff\xff\xff\xff\xff\xff\xff\x7f") == std::numeric_limits<std::int64_t>::max());
  CHECK(integer("\x80\x02J\xfe\xff\xff\xff.") == -2);  // BININT
  CHECK(integer("\x80\x02M\xfe\xff.") == 65534);       // BININT2 has no sign
  CHECK_THROWS_WITH(long1("\x00\x00\x00\x00\x00\x00\x00\x00\x01"s), Catch::Contains("64 bits"));
}

TEST_CASE("a pickle that is cut short or does more than weights need is refused") {
  CHECK_THROWS_WITH(read_pickle("\x80\x02X\x05"), Catch::Contains("cut short"));
  CHECK_THROWS_WITH(read_pickle("\x80\x02."), Catch::Contains("damaged"));
  CHECK_THROWS_WITH(read_pickle("\x80\x02i"), Catch::Contains("do not need"));
}
