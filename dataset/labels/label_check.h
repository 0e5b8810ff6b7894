#pragma once

#include <string>
#include <vector>

#include "dataset/labels/label.h"

namespace cps {

/// What computing a label again showed.
struct LabelCheck {
  /// Largest distance between a pixel and distort(undistort(pixel)), over a grid of pixels.
  double max_roundtrip_px = 0;
  /// From the frame to the nearest point of the master's rim seen through the lens; negative: inside.
  double rim_margin_px = 0;
  std::vector<std::string> faults;
};

/// Computes again what a label claims: the lens is one-to-one on the master, the crop shows no border (the
/// master's rim never lies inside the frame), zoom, true angles, numbers within their limits.
LabelCheck check_label(const Label& label);

}  // namespace cps
