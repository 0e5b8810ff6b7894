#include "apps/pictures/netpbm16.h"

#include <cctype>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

#include "files/files.h"

namespace cps {
namespace {

struct Header {
  int width = 0, height = 0, channels = 0, max_value = 0;
  std::size_t end = 0;  ///< where the values begin
  bool is_16_bit() const {
    return channels > 0 && width > 0 && height > 0 && max_value > 255 && max_value < 65536;
  }
};

/// Of the binary kinds P5 and P6; empty for other files. Comments run from '#' to the end of the line.
Header read_header(std::string_view bytes) {
  Header header;
  if (!bytes.starts_with("P5") && !bytes.starts_with("P6")) return {};
  std::size_t at = 2;
  for (int* number : {&header.width, &header.height, &header.max_value}) {
    while (at < bytes.size() &&
           (std::isspace(static_cast<unsigned char>(bytes[at])) != 0 || bytes[at] == '#'))
      at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
    for (int digits = 0; at < bytes.size() && std::isdigit(static_cast<unsigned char>(bytes[at])) != 0; ++at)
      if (++digits < 8) *number = 10 * *number + (bytes[at] - '0');
  }
  header.channels = bytes[1] == '5' ? 1 : 3;
  header.end = at + 1;
  return header;
}

}  // namespace

bool is_netpbm16(const std::filesystem::path& file) {
  std::string start(512, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return read_header(start).is_16_bit();
}

OIIO::ImageBuf read_netpbm16(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const Header header = read_header(bytes);
  const std::size_t values = std::size_t{1} * header.width * header.height * header.channels;
  if (header.end > bytes.size() || (bytes.size() - header.end) / 2 < values)
    throw std::runtime_error(file.string() + ": is damaged: the file ends too early");
  OIIO::ImageBuf pixels(
      OIIO::ImageSpec(header.width, header.height, header.channels, OIIO::TypeDesc::UINT16));
  auto* to = static_cast<std::uint16_t*>(pixels.localpixels());
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data()) + header.end;
  for (std::size_t i = 0; i < values; ++i)
    to[i] = static_cast<std::uint16_t>(from[2 * i] << 8 | from[2 * i + 1]);
  return pixels;
}

void write_netpbm16(const std::filesystem::path& file, const OIIO::ImageBuf& pixels) {
  const OIIO::ImageSpec& spec = pixels.spec();
  std::string bytes = std::string(spec.nchannels == 1 ? "P5" : "P6") + "\n" + std::to_string(spec.width) +
                      " " + std::to_string(spec.height) + "\n65535\n";
  const OIIO::ImageBuf whole = pixels.copy(OIIO::TypeDesc::UINT16);
  const auto* values = static_cast<const std::uint16_t*>(whole.localpixels());
  for (std::size_t i = 0; i < spec.image_pixels() * spec.nchannels; ++i) {
    bytes += static_cast<char>(values[i] >> 8);
    bytes += static_cast<char>(values[i] & 255);
  }
  write_file(file, bytes);
}

}  // namespace cps
