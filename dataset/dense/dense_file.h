#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "distortion/image_size.h"
#include "sampler/recipe/dense_label.h"

/// The files of an image's dense labels, beside it. The same pixels give the same bytes.
///
/// Floats in an EXR:
///   depth, distance   channel Z, and Y: metres; infinite where nothing is
///   normal, rays      X, Y, Z: unit vector, camera frame (x right, y down, z forward)
///   up                X, Y: unit vector in the picture (x right, y down)
///   latitude          Y: degrees above the horizon
/// 16-bit numbers in a PNG of one channel:
///   instance, semantic
namespace cps {

/// `000017.depth.exr` for the image `000017.png`, in the same folder.
std::filesystem::path dense_file(const std::filesystem::path& image, DenseLabel label);

/// Whether dense_file() gives this name to an image's label.
bool is_dense_file(const std::filesystem::path& file);

/// Type (float or uint16) and channels of the label's pixels, as listed above.
OIIO::ImageSpec dense_spec(DenseLabel label, ImageSize size);

/// The bytes of the label's file: an EXR of floats, losslessly compressed (ZIP, scanlines), or a PNG. Throws
/// std::runtime_error when there are no pixels, or not of dense_spec()'s type and number of channels.
std::string encode_dense(const OIIO::ImageBuf& pixels, DenseLabel label);

/// The pixels in such a file, as dense_spec() says. Throws std::runtime_error with one line, file first, when
/// it cannot be read or does not hold what is listed above.
OIIO::ImageBuf read_dense(const std::filesystem::path& file, DenseLabel label);

}  // namespace cps
