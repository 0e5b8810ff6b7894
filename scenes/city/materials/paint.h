#pragma once

#include <array>
#include <functional>

#include "scenes/city/image.h"

/// The images of a material from a function of the point on its tile. Coordinates: u, v in [0, 1).
namespace cps::city {

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
