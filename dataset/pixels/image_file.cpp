#include "dataset/pixels/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <vector>

#include "files/files.h"
#include "files/png.h"

namespace cps {
namespace {

constexpr float largest_half = 65504;

std::string encode_by_oiio(const char* kind, OIIO::ImageSpec spec, const OIIO::ImageBuf& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(kind);
  const bool is_written = out && out->set_ioproxy(&memory) && out->open(std::string("image.") + kind, spec) &&
                          out->write_image(image.spec().format, image.localpixels()) && out->close();
  if (!is_written)
    throw std::runtime_error(std::string(kind) +
                             " encoding failed: " + (out ? out->geterror() : OIIO::geterror()));
  return {bytes.begin(), bytes.end()};
}

std::string encode_jpeg(const OIIO::ImageBuf& image, int quality) {
  OIIO::ImageSpec spec(image.spec().width, image.spec().height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("compression", "jpeg:" + std::to_string(quality));
  spec.attribute("jpeg:subsampling", "4:4:4");
  return encode_by_oiio("jpg", spec, image);
}

OIIO::ImageBuf in_half_range(const OIIO::ImageBuf& image) {
  return OIIO::ImageBufAlgo::clamp(image, 0.0f, largest_half);
}

std::string encode_exr(const OIIO::ImageBuf& image) {
  OIIO::ImageSpec spec(image.spec().width, image.spec().height, 3, OIIO::TypeDesc::HALF);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // otherwise OpenImageIO writes the time of day
  return encode_by_oiio("exr", spec, in_half_range(image));
}

/// All pixels of an opened file; `name` is for error messages.
OIIO::ImageBuf pixels_of(OIIO::ImageInput* in, OIIO::TypeDesc type, const std::string& name) {
  if (!in) throw std::runtime_error(name + ": cannot be decoded: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = in->spec();
  OIIO::ImageBuf pixels(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, type));
  if (!in->read_image(0, 0, 0, spec.nchannels, type, pixels.localpixels()))
    throw std::runtime_error(name + ": cannot be decoded: " + in->geterror());
  return pixels;
}

/// The pixels of a file in memory; `name` tells its format.
OIIO::ImageBuf decoded(const char* name, const std::string& bytes, OIIO::TypeDesc type) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  return pixels_of(OIIO::ImageInput::open(name, nullptr, &memory).get(), type, name);
}

}  // namespace

std::string encode_image(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality) {
  if (format == ImageFormat::jpeg) return encode_jpeg(image, jpeg_quality);
  if (format == ImageFormat::exr) return encode_exr(image);
  return encode_png(image);
}

OIIO::ImageBuf read_pixels(const std::filesystem::path& file) {
  const OIIO::TypeDesc type = file.extension() == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8;
  // Not by an ImageBuf of that name: its cache may still hold an older file.
  return pixels_of(OIIO::ImageInput::open(file.string()).get(), type, file.string());
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
