#include <catch2/catch.hpp>

#include "tests/dataset/small_dataset.h"

using namespace cps;

TEST_CASE("SHA-256 agrees with the published test vectors (FIPS 180-4)") {
  CHECK(sha256(std::string("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256(std::string()) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("a written file is whole or not there") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  write_file(folder / "a" / "b.txt", std::string("hello"));
  CHECK(read_file(folder / "a" / "b.txt") == "hello");
  write_file(folder / "blocked", std::string("a file, not a folder"));
  CHECK_THROWS_WITH(write_file(folder / "blocked" / "c.txt", std::string("x")),
                    Catch::Contains("blocked/c.txt"));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    files += entry.is_regular_file();
  CHECK(files == 2);
  CHECK_THROWS_WITH(read_file(folder / "none"), Catch::Contains("none"));
  write_file(folder / "bad.json", std::string("{\"a\": }"));
  CHECK_THROWS_WITH(read_json(folder / "bad.json"),
                    Catch::Contains("bad.json") && Catch::Contains("not JSON"));
}

TEST_CASE("PNG bytes decode to the pixels they were made from and do not vary") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  OIIO::ImageBuf image(OIIO::ImageSpec(37, 21, 3, OIIO::TypeDesc::UINT8));
  auto* pixels = static_cast<std::uint8_t*>(image.localpixels());
  for (int i = 0; i < 3 * 37 * 21; ++i)
    pixels[i] = static_cast<std::uint8_t>(random_bits(make_stream(0, "png"), i));
  const std::string bytes = encode_png(image);
  CHECK(bytes == encode_png(image));
  write_file(folder / "a.png", bytes);
  OIIO::ImageBuf read((folder / "a.png").string());
  REQUIRE(read.read(0, 0, true, OIIO::TypeDesc::UINT8));
  CHECK(pixels_sha256(read) == pixels_sha256(image));
}
