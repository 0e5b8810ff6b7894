#include "scenes/gltf/materials/images.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <boost/crc.hpp>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>

#include "scenes/gltf/document/accessors.h"

namespace cps::gltf {
namespace {

constexpr int max_side = 16384;

/// The encoded image, from its buffer view or as read from its URI.
std::span<const unsigned char> encoded_bytes(const Document& document, int index, const std::string& where) {
  const tinygltf::Image& image = document.model.images[index];
  if (image.bufferView != -1) return bytes_of_view(document, image.bufferView, 0, where);
  if (image.image.empty())
    refuse(document, where, "\"" + image.uri + "\" cannot be read beside the glTF file: is it there?");
  return image.image;
}

bool starts_with(std::span<const unsigned char> bytes, std::string_view magic, std::size_t offset = 0) {
  return bytes.size() >= offset + magic.size() &&
         std::memcmp(bytes.data() + offset, magic.data(), magic.size()) == 0;
}

/// OpenImageIO's name for the format with this signature. Only formats that glTF allows, so that no other
/// decoder sees untrusted bytes.
const char* format_name(const Document& document, std::span<const unsigned char> bytes,
                        const std::string& where) {
  if (starts_with(bytes, "\x89PNG")) return "png";
  if (starts_with(bytes, "\xff\xd8\xff")) return "jpeg";
  if (starts_with(bytes, "RIFF") && starts_with(bytes, "WEBP", 8)) return "webp";
  const char* known = starts_with(bytes, "\xabKTX 20") ? "KTX2"
                      : starts_with(bytes, "DDS ")     ? "DDS"
                                                       : nullptr;
  refuse(document, where,
         known ? std::string(known) + " images are not supported: convert to PNG or JPEG"
               : std::string("is neither PNG, JPEG nor WebP"));
}

/// Whether a PNG's chunks (length, type, data, checksum; IEND last) are complete and their checksums right.
/// Checked here because libpng would report the error on the terminal.
bool is_whole_png(std::span<const unsigned char> bytes) {
  const auto big_endian_u32 = [&](std::size_t at) {
    return std::uint32_t{bytes[at]} << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
  };
  std::size_t at = 8;
  while (bytes.size() >= at + 12) {
    const std::size_t length = big_endian_u32(at);
    if (length > bytes.size() - at - 12) return false;
    boost::crc_32_type checksum;
    checksum.process_bytes(&bytes[at + 4], length + 4);
    if (checksum.checksum() != big_endian_u32(at + 8 + length)) return false;
    if (starts_with(bytes, "IEND", at + 4)) return true;
    at += 12 + length;
  }
  return false;
}

/// Converts 1 to 4 channels to RGBA: gray becomes red = green = blue, a missing alpha 255.
void to_rgba(const std::vector<std::uint8_t>& pixels, int channels, std::vector<std::uint8_t>& rgba) {
  const bool has_alpha = channels == 2 || channels == 4;
  const int green = channels >= 3 ? 1 : 0, blue = channels >= 3 ? 2 : 0;
  for (std::size_t i = 0, n = rgba.size() / 4; i < n; ++i) {
    const std::uint8_t* from = &pixels[i * channels];
    std::uint8_t* to = &rgba[i * 4];
    to[0] = from[0];
    to[1] = from[green];
    to[2] = from[blue];
    to[3] = has_alpha ? from[channels - 1] : 255;
  }
}

}  // namespace

DecodedImage decode_image(Document& document, int index) {
  const std::string where = element("images", index);
  const std::span<const unsigned char> bytes = encoded_bytes(document, index, where);
  const char* format = format_name(document, bytes, where);
  const auto fail = [&](const std::string& why) {
    refuse(document, where, std::string(format) + " cannot be decoded (" + why + "): is the file complete?");
  };

  if (format == std::string_view("png") && !is_whole_png(bytes)) fail("chunks or checksums are broken");
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input || !input->supports("ioproxy") || !input->set_ioproxy(&memory))
    refuse(document, where,
           std::string("this build of OpenImageIO does not read ") + format + " from memory");
  OIIO::ImageSpec keep_alpha, spec;
  keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(where + "." + format, spec, keep_alpha)) fail(input->geterror());
  if (spec.width < 1 || spec.height < 1 || spec.width > max_side || spec.height > max_side)
    refuse(document, where,
           "is " + std::to_string(spec.width) + "×" + std::to_string(spec.height) + ", sides may be 1 to " +
               std::to_string(max_side));
  if (spec.nchannels < 1 || spec.nchannels > 4) fail(std::to_string(spec.nchannels) + " channels");

  const std::size_t count = static_cast<std::size_t>(spec.width) * spec.height;
  reserve_memory(document, where, count, 4);
  std::vector<std::uint8_t> pixels(count * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()))
    fail(input->geterror());
  DecodedImage image{spec.width, spec.height, std::vector<std::uint8_t>(count * 4)};
  to_rgba(pixels, spec.nchannels, image.rgba);
  return image;
}

}  // namespace cps::gltf
