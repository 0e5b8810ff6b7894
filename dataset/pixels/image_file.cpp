#include "dataset/pixels/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

#include "dataset/pixels/codec.h"
#include "files/files.h"
#include "files/png.h"

namespace cps {
namespace {

std::string encode_jpeg(const OIIO::ImageBuf& image, int quality) {
  OIIO::ImageSpec spec(image.spec().width, image.spec().height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("compression", "jpeg:" + std::to_string(quality));
  spec.attribute("jpeg:subsampling", "4:4:4");
  return encode_by_oiio("jpg", spec, image);
}

OIIO::ImageBuf in_half_range(const OIIO::ImageBuf& image) {
  return OIIO::ImageBufAlgo::clamp(image, 0.0f, largest_half);
}

/// The pixels of a file in memory; `name` tells its format.
OIIO::ImageBuf decoded(const char* name, const std::string& bytes, OIIO::TypeDesc type) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  return pixels_of(*open_image(name, &memory), type);
}

}  // namespace

std::string encode_image(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality) {
  if (format == ImageFormat::jpeg) return encode_jpeg(image, jpeg_quality);
  if (format == ImageFormat::exr)
    return encode_exr(in_half_range(image), OIIO::TypeDesc::HALF, {"R", "G", "B"});
  return encode_png(image);
}

OIIO::ImageBuf read_pixels(const std::filesystem::path& file) {
  const OIIO::TypeDesc type = file.extension() == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8;
  try {
    return pixels_of(*open_image(file), type);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": cannot be decoded: " + error.what());
  }
}

std::string pixels_sha256(const OIIO::ImageBuf& image) {
  const auto* pixels = static_cast<const char*>(image.localpixels());
  return sha256({pixels, image.spec().image_bytes()});
}

std::string stored_pixels_sha256(const OIIO::ImageBuf& image, ImageFormat format, const std::string& bytes) {
  if (format == ImageFormat::jpeg) return pixels_sha256(decoded("image.jpg", bytes, OIIO::TypeDesc::UINT8));
  if (format == ImageFormat::exr) return pixels_sha256(decoded("image.exr", bytes, OIIO::TypeDesc::HALF));
  return pixels_sha256(image);
}

OIIO::ImageBuf stored_pixels(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality) {
  if (format == ImageFormat::jpeg)
    return decoded("image.jpg", encode_jpeg(image, jpeg_quality), OIIO::TypeDesc::UINT8);
  if (format == ImageFormat::exr) return in_half_range(image).copy(OIIO::TypeDesc::HALF);
  return image;
}

}  // namespace cps
