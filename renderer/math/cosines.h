#pragma once

#include <algorithm>
#include <cmath>

/// Arithmetic with angles in [0, π] that are given by their cosines.
namespace cps {

inline float sine_of(float cosine) {
  return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
}

/// Cosine of a + b, limited to half a turn.
inline float cos_of_sum(float cos_a, float cos_b) {
  if (cos_a + cos_b <= 0.0f) return -1.0f;
  return cos_a * cos_b - sine_of(cos_a) * sine_of(cos_b);
}

/// Cosine of a − b, limited to 0 from below.
inline float cos_of_difference(float cos_a, float cos_b) {
  if (cos_a >= cos_b) return 1.0f;
  return cos_a * cos_b + sine_of(cos_a) * sine_of(cos_b);
}

}  // namespace cps
