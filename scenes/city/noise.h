#pragma once

#include "random/counter_hash.h"

/// Tileable noise. Coordinates run over the tile: u, v in [0, 1).
namespace cps::city {

/// Gradient noise (Perlin 2002) in about [−1, 1] that repeats after `period` lattice cells in u and v.
double gradient_noise(Stream stream, double u, double v, int period);

/// `octaves` of gradient noise, each at twice the frequency and half the amplitude; in about [−1, 1].
double fractal_noise(Stream stream, double u, double v, int period, int octaves);

/// Distances to the nearest and second nearest of scattered points (Worley 1996), in cells; and the nearest's
/// number.
struct Cell {
  double nearest = 0, second = 0;
  std::uint64_t id = 0;
};
Cell cellular_noise(Stream stream, double u, double v, int period);

}  // namespace cps::city
