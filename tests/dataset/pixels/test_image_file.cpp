#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "dataset/pixels/image_file.h"
#include "files/files.h"
#include "random/counter_hash.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr ImageFormat formats[] = {ImageFormat::png, ImageFormat::png_gray, ImageFormat::jpeg,
                                   ImageFormat::exr};

/// Noise, as the format is given it.
OIIO::ImageBuf noise_for(ImageFormat format) {
  const int channels = format == ImageFormat::png_gray ? 1 : 3;
  const bool is_linear = format == ImageFormat::exr;
  OIIO::ImageBuf image(
      OIIO::ImageSpec(41, 23, channels, is_linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8));
  for (int i = 0; i < 41 * 23 * channels; ++i) {
    const std::uint64_t bits = random_bits(make_stream(0, "pixels"), i);
    if (is_linear)
      static_cast<float*>(image.localpixels())[i] = static_cast<float>(bits % 4096) / 1000;
    else
      static_cast<std::uint8_t*>(image.localpixels())[i] = static_cast<std::uint8_t>(bits);
  }
  return image;
}

}  // namespace

TEST_CASE("an image's file does not depend on the time of writing") {
  // OpenImageIO puts the time of day into an EXR unless it is given one.
  std::vector<std::string> before;
  for (ImageFormat format : formats) before.push_back(encode_image(noise_for(format), format, 90));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  for (std::size_t i = 0; i < std::size(formats); ++i) {
    INFO(to_string(formats[i]));
    CHECK(encode_image(noise_for(formats[i]), formats[i], 90) == before[i]);
  }
}

TEST_CASE("the hash of an image's pixels is that of the pixels a reader decodes") {
  const TemporaryFolder folder;
  for (ImageFormat format : formats) {
    INFO(to_string(format));
    const OIIO::ImageBuf image = noise_for(format);
    const std::string bytes = encode_image(image, format, 90);
    const auto file = folder.path / ("image." + extension_of(format));
    write_file(file, bytes);
    const OIIO::ImageBuf read = read_pixels(file);
    CHECK(read.spec().nchannels == image.spec().nchannels);
    CHECK(stored_pixels_sha256(image, format, bytes) == pixels_sha256(read));
    const bool is_lossless = format == ImageFormat::png || format == ImageFormat::png_gray;
    if (is_lossless) CHECK(pixels_sha256(read) == pixels_sha256(image));
  }
}

TEST_CASE("an EXR holds the nearest half floats, clamped to the finite range") {
  const TemporaryFolder folder;
  OIIO::ImageBuf image = noise_for(ImageFormat::exr);
  auto* given = static_cast<float*>(image.localpixels());
  given[0] = 1e6f;  // the sun
  write_file(folder.path / "a.exr", encode_image(image, ImageFormat::exr, 90));
  OIIO::ImageBuf read;
  read.copy(read_pixels(folder.path / "a.exr"), OIIO::TypeDesc::FLOAT);
  const auto* found = static_cast<const float*>(read.localpixels());
  CHECK(found[0] == 65504);
  for (int i = 1; i < 41 * 23 * 3; ++i) CHECK(std::abs(found[i] - given[i]) <= given[i] / 2048 + 1e-7f);
}
