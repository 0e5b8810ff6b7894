#pragma once

#include <vector>

#include "distortion/warp/render_noise.h"
#include "random/counter_hash.h"

namespace cps {

/// A render of a wall without texture that fills the view: all structure in it is render noise. It is
/// rendered once with the project's path tracer, and masters of any size are cut out of it.
struct NoiseWall {
  NoisyMaster master;
};

enum class WallLight {
  shade,  ///< a clear sky without its sun: every ray meets another part of it
  sunlit  ///< sun and clear sky
};

/// `samples` per master pixel, in two halves.
NoiseWall render_noise_wall(WallLight light, int samples, int side_px, std::uint64_t seed);

/// A rectangle of the wall at a random place, in a random one of its four mirrored positions. Throws
/// std::runtime_error when the wall is smaller than the rectangle.
NoisyMaster cut_master(const NoiseWall& wall, int width, int height, Stream stream);

/// Standard deviation of the picture over its mean, green channel.
double relative_noise(const NoiseWall& wall);

}  // namespace cps
