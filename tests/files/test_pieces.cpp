#include <catch2/catch.hpp>

#include "files/files.h"
#include "files/pieces.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("a hash of pieces is that of the whole, in memory and in a file") {
  const TemporaryFolder temporary;
  const std::string bytes(3'000'000, 'a');
  Sha256 hash;
  for (std::size_t at = 0; at < bytes.size(); at += 700'001)
    hash.add(std::string_view(bytes).substr(at, 700'001));
  CHECK(hash.hex() == sha256(bytes));
  write_file(temporary.path / "a", bytes);
  write_file(temporary.path / "empty", std::string());
  CHECK(sha256_of_file(temporary.path / "a") == sha256(bytes));
  CHECK(sha256_of_file(temporary.path / "empty") == sha256(std::string()));
  CHECK_THROWS_WITH(sha256_of_file(temporary.path / "none"), Catch::Contains("none: cannot be read"));
}

TEST_CASE("a file in pieces appears when the last one is written, or not at all") {
  const TemporaryFolder temporary;
  const std::filesystem::path file = temporary.path / "a" / "b.txt";
  write_in_pieces(file, [&](const Append& append) {
    append(std::string("one "));
    CHECK_FALSE(std::filesystem::exists(file));
    append(std::string("two"));
  });
  CHECK(read_file(file) == "one two");
  CHECK_THROWS_WITH(write_in_pieces(file,
                                    [](const Append& append) {
                                      append(std::string("three"));
                                      throw std::runtime_error("no more");
                                    }),
                    Catch::Contains("b.txt: cannot be written: no more"));
  CHECK(read_file(file) == "one two");
  CHECK(std::distance(std::filesystem::directory_iterator(temporary.path / "a"), {}) == 1);
}
