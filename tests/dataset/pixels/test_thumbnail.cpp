#include <OpenImageIO/imagebufalgo.h>

#include <catch2/catch.hpp>

#include "dataset/pixels/image_file.h"
#include "dataset/pixels/thumbnail.h"
#include "files/files.h"
#include "random/counter_hash.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

OIIO::ImageBuf filled(int channels, OIIO::TypeDesc type, float value) {
  OIIO::ImageBuf image(OIIO::ImageSpec(128, 96, channels, type));
  OIIO::ImageBufAlgo::fill(image, std::vector<float>(channels, value));
  return image;
}

}  // namespace

TEST_CASE("a thumbnail is 8-bit sRGB of three channels, whatever the image's format") {
  const TemporaryFolder folder;
  const auto check = [&](const char* name, const OIIO::ImageBuf& image, ImageFormat format, int expected) {
    write_file(folder.path / name, encode_image(image, format, 95));
    const OIIO::ImageBuf small = thumbnail(folder.path / name, {32, 24});
    CHECK(small.spec().format == OIIO::TypeDesc::UINT8);
    CHECK(small.spec().width == 32);
    CHECK(small.spec().height == 24);
    REQUIRE(small.nchannels() == 3);
    const auto* pixels = static_cast<const std::uint8_t*>(small.localpixels());
    for (int i = 0; i < 32 * 24 * 3; ++i) CHECK(std::abs(pixels[i] - expected) <= 1);
  };
  check("a.png", filled(3, OIIO::TypeDesc::UINT8, 0.5f), ImageFormat::png, 128);
  check("gray.png", filled(1, OIIO::TypeDesc::UINT8, 0.5f), ImageFormat::png_gray, 128);
  check("a.jpg", filled(3, OIIO::TypeDesc::UINT8, 0.5f), ImageFormat::jpeg, 128);
  check("a.exr", filled(3, OIIO::TypeDesc::FLOAT, 0.2140f), ImageFormat::exr, 127);  // sRGB's middle
  CHECK_THROWS_WITH(thumbnail(folder.path / "none.png", {32, 24}), Catch::Contains("none.png"));
}

TEST_CASE("an image that is smaller than its thumbnail is enlarged without gaps") {
  const TemporaryFolder folder;
  write_file(folder.path / "a.png",
             encode_image(filled(3, OIIO::TypeDesc::UINT8, 0.5f), ImageFormat::png, 95));
  const OIIO::ImageBuf large = thumbnail(folder.path / "a.png", {420, 315});
  const auto* pixels = static_cast<const std::uint8_t*>(large.localpixels());
  int wrong = 0;
  for (int i = 0; i < 420 * 315 * 3; ++i) wrong += std::abs(pixels[i] - 128) > 1;
  CHECK(wrong == 0);
}

TEST_CASE("an encoded thumbnail keeps to its bound, even of noise") {
  OIIO::ImageBuf noise(OIIO::ImageSpec(240, 160, 3, OIIO::TypeDesc::UINT8));
  auto* pixels = static_cast<std::uint8_t*>(noise.localpixels());
  for (int i = 0; i < 240 * 160 * 3; ++i)
    pixels[i] = static_cast<std::uint8_t>(random_bits(make_stream(1, "n"), i));
  for (std::size_t max_bytes : {60'000, 9'000, 1'000}) {
    const std::string jpeg = encode_thumbnail(noise, max_bytes);
    CHECK(jpeg.size() <= max_bytes);
    CHECK_THAT(jpeg, Catch::StartsWith("\xff\xd8\xff"));
  }
  CHECK_FALSE(encode_thumbnail(noise, 1).empty());  // the smallest there is
}
