#include "apps/pictures/picture_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>

namespace cps {
namespace {

using OIIO::TypeDesc;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace

void refuse_picture(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why.substr(0, why.find('\n')));
}

const std::vector<PictureFormat>& picture_formats() {
  const TypeDesc u8 = TypeDesc::UINT8, u16 = TypeDesc::UINT16, u32 = TypeDesc::UINT32, half = TypeDesc::HALF,
                 real = TypeDesc::FLOAT;
  static const std::vector<PictureFormat> all{{{".png"}, {u8, u16}, AlphaKind::straight},
                                              {{".jpg", ".jpeg"}, {u8}, AlphaKind::none, false},
                                              {{".exr"}, {half, real, u32}, AlphaKind::premultiplied},
                                              {{".tif", ".tiff"}, {u8, u16, u32, real}, AlphaKind::either},
                                              {{".hdr"}, {real}, AlphaKind::none, false},
                                              {{".bmp"}, {u8}},
                                              {{".tga"}, {u8}, AlphaKind::straight},
                                              {{".webp"}, {u8}, AlphaKind::straight, false},
                                              {{".ppm", ".pgm", ".pnm"}, {u8, u16}},
                                              {{".jp2"}, {u8, u16}, AlphaKind::straight},
                                              {{".dpx"}, {u8, u16}, AlphaKind::straight}};
  return all;
}

const PictureFormat* picture_format(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  for (const PictureFormat& format : picture_formats())
    if (std::ranges::find(format.extensions, extension) != format.extensions.end()) return &format;
  return nullptr;
}

bool is_read_only_picture(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 11> names{".pfm", ".gif", ".heic", ".heif", ".avif", ".psd",
                                                   ".ico", ".cr2", ".nef",  ".dng",  ".arw"};
  return std::ranges::find(names, lower_extension(file)) != names.end();
}

std::optional<TypeDesc> stored_type(const PictureFormat& format, TypeDesc source, bool is_light) {
  if (std::ranges::find(format.types, source) != format.types.end()) return source;
  if (!is_light) return std::nullopt;
  const auto holds = [&](TypeDesc type) {
    return type.is_floating_point() != source.is_floating_point() || type.size() > source.size();
  };
  const auto type = std::ranges::find_if(format.types, holds);
  return type == format.types.end() ? std::nullopt : std::optional(*type);
}

}  // namespace cps
