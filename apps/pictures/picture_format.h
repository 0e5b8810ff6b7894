#pragma once

#include <OpenImageIO/typedesc.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// File formats of still pictures: what each can hold without loss of meaning.
namespace cps {

/// What the alpha of a file's colours is.
enum class AlphaKind {
  none,
  premultiplied,  ///< colours are multiplied by alpha
  straight,
  either,  ///< the file says which
};

struct PictureFormat {
  std::vector<const char*> extensions;
  std::vector<OIIO::TypeDesc> types;  ///< pixel types that are written and read back as they are
  AlphaKind alpha = AlphaKind::none;
  bool is_lossless = true;
};

/// Throws std::runtime_error `<file>: <why>`, of which only the first line is kept: OpenImageIO's messages
/// may have several.
[[noreturn]] void refuse_picture(const std::filesystem::path& file, const std::string& why);

/// All formats that cps writes.
const std::vector<PictureFormat>& picture_formats();

/// The format that the name ends with, whatever its case; nullptr if cps writes no such format.
const PictureFormat* picture_format(const std::filesystem::path& file);

/// Whether the name is that of a picture in a format that is read but not written (.gif, .pfm, .heic, …).
bool is_read_only_picture(const std::filesystem::path& file);

/// The pixel type in which the format stores pixels of type `source`; none if it has no place for them.
/// `is_light`: pixels may become the usual numbers of the format (8 bits from float, half from 8 bits), but
/// not fewer bits of the same kind. Otherwise they keep their type.
std::optional<OIIO::TypeDesc> stored_type(const PictureFormat& format, OIIO::TypeDesc source, bool is_light);

}  // namespace cps
