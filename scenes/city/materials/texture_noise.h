#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "random/counter_hash.h"

/// Tileable noise and the images made from it. Coordinates run over the tile: u, v in [0, 1).
namespace cps::city {

/// 8-bit pixels, rows from the top, `channels` per pixel.
struct Image {
  int width = 0, height = 0, channels = 3;
  std::vector<std::uint8_t> pixels;
};

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

/// What a surface looks like at one point of the tile.
struct Texel {
  std::array<double, 3> color = {0.5, 0.5, 0.5};  ///< sRGB, 0 … 1
  double height_m = 0;
  double roughness = 0.8, metallic = 0;
  double alpha = 1;
};

/// The images of a material: base colour (RGBA where alpha is used), normal map (from the heights over a tile
/// of `tile_m` metres), occlusion-roughness-metallic.
struct TextureSet {
  Image base_color, normal, metallic_roughness;
};

TextureSet paint(int size, double tile_m, bool with_alpha,
                 const std::function<Texel(double u, double v)>& texel);

}  // namespace cps::city
