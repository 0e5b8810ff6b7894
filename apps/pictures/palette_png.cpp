#include "apps/pictures/palette_png.h"

#include <png.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>

namespace cps {

bool is_palette_png(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t colour_type_at = 25;  // in IHDR, which is always first
  std::array<char, colour_type_at + 1> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), signature.size()) == signature &&
         start[colour_type_at] == PNG_COLOR_TYPE_PALETTE;
}

OIIO::ImageBuf read_palette_png(const std::filesystem::path& file, Palette& palette) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  OIIO::ImageBuf numbers;
  if (png_image_begin_read_from_file(&png, file.c_str()) != 0) {
    png.format = PNG_FORMAT_RGBA_COLORMAP;  // of a palette: its numbers and colours as they are
    palette.resize(PNG_IMAGE_COLORMAP_SIZE(png));
    numbers.reset(
        OIIO::ImageSpec(static_cast<int>(png.width), static_cast<int>(png.height), 1, OIIO::TypeDesc::UINT8));
    if (png_image_finish_read(&png, nullptr, numbers.localpixels(), 0, palette.data()) != 0) {
      palette.resize(std::size_t{4} * png.colormap_entries);
      return numbers;
    }
  }
  const std::string why = png.message;
  png_image_free(&png);
  throw std::runtime_error(file.string() + ": is damaged: " + why);
}

void write_palette_png(const std::filesystem::path& file, const OIIO::ImageBuf& numbers,
                       const Palette& palette) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(numbers.spec().width);
  png.height = static_cast<png_uint_32>(numbers.spec().height);
  png.format = PNG_FORMAT_RGBA_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(palette.size() / 4);
  if (png_image_write_to_file(&png, file.c_str(), 0, numbers.localpixels(), 0, palette.data()) == 0)
    throw std::runtime_error(png.message);
}

}  // namespace cps
