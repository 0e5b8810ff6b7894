#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

#include "dataset/labels/reader.h"

namespace cps {

struct ContactSheetOptions {
  int rows_per_set = 2;  ///< views shown of each set
  int columns = 5;       ///< images shown of each view: the undistorted one and the first lenses
  int tile_width_px = 420;
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// A picture of the dataset's images with their labels below them: a row per view, a column per lens. Throws
/// std::runtime_error that names an image which cannot be read.
OIIO::ImageBuf contact_sheet(const Dataset& dataset, const ContactSheetOptions& options);

}  // namespace cps
