#pragma once

#include <array>
#include <functional>

#include "scenes/city/image.h"

/// Paints the images of a material from a function of the point on its tile: u, v in [0, 1), v down.
namespace cps::city {

/// A surface's appearance at one point of the tile.
struct Texel {
  std::array<double, 3> color = {0.5, 0.5, 0.5};  ///< sRGB, 0 … 1
  double height_m = 0;
  double roughness = 0.8, metallic = 0;
  double alpha = 1;
};

/// The images of a material: base colour (RGB or RGBA), normal map, and occlusion-roughness-metallic.
struct TextureSet {
  Image base_color, normal, metallic_roughness;
};

/// Paints `size`² pixels of a tile `tile_m` wide, which scales the heights for the normal map. Calls `texel`
/// from several threads.
TextureSet paint(int size, double tile_m, bool with_alpha,
                 const std::function<Texel(double u, double v)>& texel);

}  // namespace cps::city
