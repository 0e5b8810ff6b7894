#include <catch2/catch.hpp>

#include "dataset/export/tar.h"

using namespace cps;

namespace {

std::string tar_of(const std::string& name, const std::string& bytes) {
  std::string tar;
  const Append append = [&](std::span<const char> piece) { tar.append(piece.begin(), piece.end()); };
  add_to_tar(append, name, bytes);
  end_tar(append);
  return tar;
}

}  // namespace

TEST_CASE("a tar's header has each field where POSIX puts it, and the sum of its bytes") {
  const std::string bytes(1000, 'x'), tar = tar_of("000000007.png", bytes);
  CHECK(tar.size() == 512 + 1024 + 1024);
  CHECK(tar.substr(0, 14) == std::string("000000007.png\0", 14));
  CHECK(tar.substr(124, 12) == std::string("00000001750\0", 12));  // 1000 in octal
  CHECK(tar.substr(136, 12) == std::string("00000000000\0", 12));
  CHECK(tar[156] == '0');
  CHECK(tar.substr(257, 8) == std::string("ustar\0"
                                          "00",
                                          8));
  int sum = 0;
  for (int i = 0; i < 512; ++i) sum += i >= 148 && i < 156 ? ' ' : static_cast<unsigned char>(tar[i]);
  CHECK(std::stoi(tar.substr(148, 6), nullptr, 8) == sum);
  CHECK(tar.substr(512, 1000) == bytes);
  CHECK(tar.substr(1512) == std::string(24 + 1024, '\0'));
}

TEST_CASE("a tar's size is known before it is written") {
  for (std::size_t bytes : {0, 1, 511, 512, 513, 4096})
    CHECK(tar_of("a", std::string(bytes, '1')).size() == size_in_tar(bytes) + tar_end_bytes);
}

TEST_CASE("a tar takes names of up to a hundred bytes and refuses others") {
  CHECK(tar_of(std::string(100, 'n'), "1").substr(0, 100) == std::string(100, 'n'));
  CHECK_THROWS_WITH(tar_of(std::string(101, 'n'), "1"), Catch::Contains("1 to 100 bytes"));
  CHECK_THROWS_WITH(tar_of("", "1"), Catch::Contains("1 to 100 bytes"));
}
