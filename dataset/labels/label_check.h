#pragma once

#include <string>
#include <vector>

#include "dataset/labels/label.h"

namespace cps {

/// What computing a label anew showed.
struct LabelCheck {
  double worst_roundtrip_px = 0;
  double rim_margin_px =
      0;  ///< from the frame to the nearest point of the master's rim seen through the lens; negative: inside
  std::vector<std::string> faults;
};

/// Recomputes what a label claims: one-to-one on the master, crop (the master's rim never inside the frame),
/// zoom, true angles, numbers within their limits.
LabelCheck check_label(const Label& label);

}  // namespace cps
