#pragma once

namespace cps {

/// Y of a linear Rec. 709 colour.
inline float luminance(float red, float green, float blue) {
  return 0.2126f * red + 0.7152f * green + 0.0722f * blue;
}

}  // namespace cps
