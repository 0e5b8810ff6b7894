#include "dataset/report/report_options.h"

namespace cps {

std::string ReportOptions::fault() const {
  if (thumbnails < 0 || thumbnails > 400) return "thumbnails: must lie in [0, 400]";
  if (rows_per_set < 1 || rows_per_set > 100) return "rows: must lie in [1, 100]";
  if (columns < 1 || columns > 20) return "columns: must lie in [1, 20]";
  if (thumbnail_width_px < 32 || thumbnail_width_px > 640) return "thumbnail-width: must lie in [32, 640]";
  if (lenses < 1 || lenses > 2000) return "lenses: must lie in [1, 2000]";
  return "";
}

}  // namespace cps
