#pragma once

#include "random/counter_hash.h"

/// Noise that tiles: one tile is u, v in [0, 1).
namespace cps::city {

/// Gradient noise (Perlin 2002), about [−1, 1], with `period` lattice cells along each side of the tile.
double gradient_noise(Stream stream, double u, double v, int period);

/// A sum of `octaves` gradient noises, each at twice the frequency and half the amplitude of the one before;
/// about [−1, 1].
double fractal_noise(Stream stream, double u, double v, int period, int octaves);

/// The nearest of the scattered points of cellular noise (Worley 1996).
struct CellularNoise {
  double nearest = 0, second = 0;  ///< distances to the nearest and second nearest point, in cells
  std::uint64_t id = 0;            ///< of the nearest point

  /// Uniform in [0, 1), the same wherever the same point is the nearest.
  double uniform() const { return static_cast<double>(mix64(id) >> 11) * 0x1p-53; }
};

/// Cellular noise of `period`² points per tile, one at random in each cell.
CellularNoise cellular_noise(Stream stream, double u, double v, int period);

}  // namespace cps::city
