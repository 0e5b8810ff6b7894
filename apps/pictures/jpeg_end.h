#pragma once

#include <string_view>

namespace cps {

/// Whether a JPEG file holds its image to the end. libjpeg fills a missing part with gray without an error.
/// What follows the image (thumbnails, a second picture, a phone's notes) does not matter.
bool has_whole_image(std::string_view jpeg);

}  // namespace cps
