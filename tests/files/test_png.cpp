#include <catch2/catch.hpp>

#include "files/files.h"
#include "files/png.h"
#include "random/counter_hash.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("PNG bytes decode to the encoded pixels, and are the same each time") {
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
  REQUIRE(read.spec().nchannels == 3);
  const auto* decoded = static_cast<const std::uint8_t*>(read.localpixels());
  CHECK(std::equal(pixels, pixels + 3 * 37 * 21, decoded));
}

TEST_CASE("PNG of 16 bits: every number decodes to itself") {
  const TemporaryFolder folder;
  OIIO::ImageBuf image(OIIO::ImageSpec(256, 256, 1, OIIO::TypeDesc::UINT16));
  auto* numbers = static_cast<std::uint16_t*>(image.localpixels());
  for (int i = 0; i < 65536; ++i) numbers[i] = static_cast<std::uint16_t>(40503u * i);  // each number once
  write_file(folder.path / "a.png", encode_png(image));
  OIIO::ImageBuf read((folder.path / "a.png").string());
  REQUIRE(read.read(0, 0, true, OIIO::TypeDesc::UINT16));
  CHECK(read.nativespec().format == OIIO::TypeDesc::UINT16);
  REQUIRE(read.spec().nchannels == 1);
  CHECK(std::equal(numbers, numbers + 65536, static_cast<const std::uint16_t*>(read.localpixels())));
}

TEST_CASE("PNG refuses what it has no form for") {
  for (const OIIO::ImageSpec& spec :
       {OIIO::ImageSpec(2, 2, 2, OIIO::TypeDesc::UINT8), OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::UINT16),
        OIIO::ImageSpec(2, 2, 1, OIIO::TypeDesc::FLOAT)})
    CHECK_THROWS_WITH(encode_png(OIIO::ImageBuf(spec)), Catch::Contains("needs 8 bits"));
}
