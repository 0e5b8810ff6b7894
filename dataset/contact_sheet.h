#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

#include "dataset/labels/reader.h"

namespace cps {

struct ContactSheetOptions {
  int rows_per_set = 2;  ///< views shown of each set
  int columns = 5;       ///< images of each view: the undistorted one and the first lenses
  int tile_width_px = 420;
  bool is_valid(std::string* why) const;
};

/// Views side by side through their lenses with the labels drawn below them: a row per view, a column per
/// lens. Throws std::runtime_error naming an image that cannot be read.
OIIO::ImageBuf contact_sheet(const Dataset& dataset, const ContactSheetOptions& options);

}  // namespace cps
