#pragma once

#include <algorithm>
#include <cmath>

#include "scenes/scene.h"

namespace cps {

/// The two texels a coordinate lies between (centres at half integers), and how far towards the second.
struct TexelPair {
  int first, second;
  float fraction;
};

/// Maps a texture coordinate into [0, 1].
inline float wrap_coordinate(float u, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return u - std::floor(u);
    case Wrap::clamp_to_edge:
      return std::clamp(u, 0.0f, 1.0f);
    case Wrap::mirrored_repeat:
      return 1.0f - std::abs(1.0f - (u - 2.0f * std::floor(0.5f * u)));
  }
  return u;
}

/// The texels next to a coordinate, on an axis of `size` texels.
inline TexelPair texel_pair(float u, int size, Wrap wrap) {
  const float x = wrap_coordinate(u, wrap) * static_cast<float>(size) - 0.5f;
  const float floor_x = std::floor(x);
  const int first = static_cast<int>(floor_x);
  TexelPair pair{first, first + 1, x - floor_x};
  if (pair.first < 0) pair.first = wrap == Wrap::repeat ? size - 1 : 0;
  if (pair.second >= size) pair.second = wrap == Wrap::repeat ? 0 : size - 1;
  return pair;
}

/// The texel that holds a coordinate.
inline int nearest_texel(float u, int size, Wrap wrap) {
  return std::min(static_cast<int>(wrap_coordinate(u, wrap) * static_cast<float>(size)), size - 1);
}

}  // namespace cps
