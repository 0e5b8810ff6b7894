#pragma once

#include <OpenImageIO/imagebuf.h>

#include <optional>

#include "distortion/models/model_camera.h"

/// Which pixels of an image show something, where a lens does not reach into the corners of its frame: a mask
/// of the images of a leaf folder, as they share their camera. Only lenses of families other than
/// Brown–Conrady have one, and only where a pixel is invalid.
namespace cps {

/// The mask's file in its leaf folder.
inline constexpr const char* valid_mask_file = "valid.png";

/// One channel of 8 bits: 255 where the lens is proved to show the pixel's whole kernel (a square of one and
/// a half pixels to each side of the centre, three standard deviations of the filter that traced images
/// have), else 0. Empty if all pixels are valid. The same for any number of threads.
std::optional<OIIO::ImageBuf> valid_mask(const ModelCamera& camera);

/// Sets all channels of the pixels to 0 that the mask has as 0. Unchecked: both have one size.
void black_out(OIIO::ImageBuf& image, const OIIO::ImageBuf& mask);

}  // namespace cps
