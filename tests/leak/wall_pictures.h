#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/leak/noise_wall.h"

namespace cps {

/// How a picture is made from its master.
enum class Resampler {
  pipeline,      ///< photograph(), as `cps generate` makes images
  unguarded,     ///< photograph() without evening out the render noise
  bilinear_8bit  ///< as many generators do: bilinear lookup in an 8-bit picture of the output's size
};

/// What a network must not be able to infer from noise.
inline constexpr int secret_count = 3;
inline constexpr std::array<const char*, secret_count> secret_names{"K1", "H-FOV", "narrowing"};

/// 8-bit gray pictures of the wall through drawn lenses, and the secrets of each: k1 in units of the
/// base's half diagonal, the label's H-FOV, and by how much the crop narrowed the base's H-FOV (degrees), the
/// part of the label that the lens alone decides.
struct WallPictures {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< picture after picture, rows from the top
  std::vector<std::array<double, secret_count>> secrets;
  std::size_t count() const { return secrets.size(); }
};

/// `count` pictures, each through its own lens, drawn as the demo recipe draws them but for smaller images.
WallPictures photograph_wall(const NoiseWall& wall, Resampler resampler, int count, Stream stream);

}  // namespace cps
