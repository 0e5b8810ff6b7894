#pragma once

#include <string>

#include "trainer/evaluation/evaluation_set.h"

namespace cps {

/// An SVG for HTML: the image in gray, at most `width_px` pixels wide, and `drawing`, SVG in pixels of the
/// image file from its top left corner, over it. `picture_opacity` below 1 lets the drawing stand out. The
/// picture is a PNG inside the SVG; it is left out if its file can no longer be read.
std::string picture_svg(const EvaluationImage& image, int width_px, double picture_opacity,
                        const std::string& drawing);

}  // namespace cps
