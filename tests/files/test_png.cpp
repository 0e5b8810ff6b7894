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
