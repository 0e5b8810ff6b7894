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

std::string header(int width, int height, int channels) {
  std::string data;
  append_number(data, static_cast<std::uint32_t>(width));
  append_number(data, static_cast<std::uint32_t>(height));
  constexpr char gray = 0, rgb = 2;
  data += {8, channels == 1 ? gray : rgb, 0, 0, 0};  // bits, colour type, deflate, filters, not interlaced
  return data;
}

/// PNG's filter SUB: each row begins with the filter's number, then every byte minus that of the same channel
/// in the pixel to the left.
std::vector<std::uint8_t> filtered_rows(const OIIO::ImageBuf& image) {
  const int height = image.spec().height, channels = image.spec().nchannels;
  const std::size_t row_bytes = static_cast<std::size_t>(image.spec().width) * channels;
  const auto* from = static_cast<const std::uint8_t*>(image.localpixels());
  std::vector<std::uint8_t> rows((row_bytes + 1) * height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* pixel = from + y * row_bytes;
    std::uint8_t* row = &rows[y * (row_bytes + 1)];
    constexpr std::uint8_t sub = 1;
    *row++ = sub;
    std::copy(pixel, pixel + channels, row);
    for (std::size_t i = channels; i < row_bytes; ++i)
      row[i] = static_cast<std::uint8_t>(pixel[i] - pixel[i - channels]);
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
  if (spec.format != OIIO::TypeDesc::UINT8 || (spec.nchannels != 1 && spec.nchannels != 3))
    throw std::runtime_error("PNG encoding failed: needs 8 bits and one or three channels");
  std::string png = "\x89PNG\r\n\x1a\n";
  append_chunk(png, "IHDR", header(spec.width, spec.height, spec.nchannels));
  append_chunk(png, "sRGB", std::string_view("\0", 1));  // perceptual
  append_chunk(png, "IDAT", deflated(filtered_rows(image)));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace cps
