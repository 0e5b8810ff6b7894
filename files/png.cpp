#include "files/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace cps {
namespace {

void append_number(std::string& bytes, std::uint32_t value) {  // big-endian
  for (int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 255);
}

void append_chunk(std::string& png, const std::string& type, std::string_view data) {
  append_number(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  png += type;
  png += data;
  append_number(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

bool is_deep(const OIIO::ImageSpec& spec) {
  return spec.format == OIIO::TypeDesc::UINT16;
}

std::string header(const OIIO::ImageSpec& spec) {
  std::string data;
  append_number(data, static_cast<std::uint32_t>(spec.width));
  append_number(data, static_cast<std::uint32_t>(spec.height));
  constexpr char gray = 0, rgb = 2;
  const char bits = is_deep(spec) ? 16 : 8, colour_type = spec.nchannels == 1 ? gray : rgb;
  data += {bits, colour_type, 0, 0, 0};  // deflate, filters, not interlaced
  return data;
}

/// The pixels' bytes with the high byte of each 16-bit number first, as PNG has them.
std::vector<std::uint8_t> high_bytes_first(const std::uint8_t* from, std::size_t count) {
  std::vector<std::uint8_t> bytes(from, from + count);
  for (std::size_t i = 0; i < count; i += 2) std::swap(bytes[i], bytes[i + 1]);
  return bytes;
}

/// PNG's filter SUB: each row begins with the filter's number, then every byte minus that of the same channel
/// in the pixel to the left.
std::vector<std::uint8_t> filtered_rows(const OIIO::ImageBuf& image) {
  const auto* from = static_cast<const std::uint8_t*>(image.localpixels());
  std::vector<std::uint8_t> swapped;
  if (is_deep(image.spec())) {
    swapped = high_bytes_first(from, image.spec().image_bytes());
    from = swapped.data();
  }
  const int height = image.spec().height;
  const std::size_t row_bytes = image.spec().scanline_bytes(), pixel_bytes = image.spec().pixel_bytes();
  std::vector<std::uint8_t> rows((row_bytes + 1) * height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* pixel = from + y * row_bytes;
    std::uint8_t* row = &rows[y * (row_bytes + 1)];
    constexpr std::uint8_t sub = 1;
    *row++ = sub;
    std::copy(pixel, pixel + pixel_bytes, row);
    for (std::size_t i = pixel_bytes; i < row_bytes; ++i)
      row[i] = static_cast<std::uint8_t>(pixel[i] - pixel[i - pixel_bytes]);
  }
  return rows;
}

std::string deflated(const std::vector<std::uint8_t>& bytes) {
  constexpr int fastest = 1;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(fastest), libdeflate_free_compressor);
  if (!compressor) throw std::runtime_error("PNG encoding failed: no memory");
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

}  // namespace

std::string encode_png(const OIIO::ImageBuf& image) {
  const OIIO::ImageSpec& spec = image.spec();
  const bool is_colour = spec.format == OIIO::TypeDesc::UINT8 && (spec.nchannels == 1 || spec.nchannels == 3);
  if (!is_colour && !(is_deep(spec) && spec.nchannels == 1))
    throw std::runtime_error(
        "PNG encoding failed: needs 8 bits and one or three channels, or 16 bits and one channel");
  std::string png = "\x89PNG\r\n\x1a\n";
  append_chunk(png, "IHDR", header(spec));
  if (is_colour) append_chunk(png, "sRGB", std::string_view("\0", 1));  // perceptual
  append_chunk(png, "IDAT", deflated(filtered_rows(image)));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace cps
