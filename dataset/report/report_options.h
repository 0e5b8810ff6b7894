#pragma once

#include <string>

namespace cps {

/// How much a report shows. All of it together bounds the page: below 10 MB for any dataset.
struct ReportOptions {
  int thumbnails = 160;  ///< most images in the contact sheets, all together
  int rows_per_set = 3;  ///< views of each set, as far as the thumbnails reach
  int columns = 4;       ///< images of one view
  int thumbnail_width_px = 280;
  int lenses = 500;  ///< that the lens picker offers
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

}  // namespace cps
