#pragma once

namespace cps::city {

/// Heights above the carriageway, metres. Markings and patches are geometry, a few millimetres above the
/// asphalt and each other.
inline constexpr double kerb_height_m = 0.12, patch_height_m = 0.002, seam_height_m = 0.0035,
                        gutter_height_m = 0.003, paint_height_m = 0.006;
inline constexpr double kerb_width_m = 0.15;

}  // namespace cps::city
