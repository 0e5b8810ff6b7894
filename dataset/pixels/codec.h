#pragma once

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Image files by OpenImageIO, without dates or names of programs in them: the same pixels give the same
/// bytes. What goes wrong is thrown as std::runtime_error with the reason in one line, not the file's name.
namespace cps {

inline constexpr float largest_half = 65504;

/// The bytes of a file of this kind (`exr`, `jpg`).
std::string encode_by_oiio(const std::string& kind, const OIIO::ImageSpec& spec, const OIIO::ImageBuf& image);

/// The bytes of an EXR of scanlines, losslessly compressed (ZIP): the image's channels under these names,
/// each stored as `type` (half or float).
std::string encode_exr(const OIIO::ImageBuf& image, OIIO::TypeDesc type,
                       const std::vector<std::string>& channels);

/// A file opened for reading, on the disk or in `memory`, where its name only tells the format.
std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& file,
                                             OIIO::Filesystem::IOProxy* memory = nullptr);

/// All pixels of an opened file.
OIIO::ImageBuf pixels_of(OIIO::ImageInput& in, OIIO::TypeDesc type);

/// The channels of these names, in this order: EXR files and their readers have orders of their own.
OIIO::ImageBuf channels_of(OIIO::ImageInput& in, OIIO::TypeDesc type,
                           const std::vector<std::string>& channels);

}  // namespace cps
