#include "scenes/city/materials/paint.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace cps::city {
namespace {

std::uint8_t to_byte(double x) {
  return static_cast<std::uint8_t>(std::clamp(x * 255.0 + 0.5, 0.0, 255.0));
}

}  // namespace

TextureSet paint(int size, double tile_m, bool with_alpha,
                 const std::function<Texel(double, double)>& texel) {
  TextureSet set;
  set.base_color = {size, size, with_alpha ? 4 : 3, {}};
  set.normal = set.metallic_roughness = {size, size, 3, {}};
  for (Image* image : {&set.base_color, &set.normal, &set.metallic_roughness})
    image->pixels.resize(static_cast<std::size_t>(size) * size * image->channels);
  std::vector<float> height(static_cast<std::size_t>(size) * size);

  tbb::parallel_for(0, size, [&](int y) {
    for (int x = 0; x < size; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size + x;
      const Texel t = texel((x + 0.5) / size, (y + 0.5) / size);
      for (int c = 0; c < 3; ++c)
        set.base_color.pixels[i * set.base_color.channels + c] = to_byte(t.color[c]);
      if (with_alpha) set.base_color.pixels[i * 4 + 3] = to_byte(t.alpha);
      set.metallic_roughness.pixels[i * 3] = 255;
      set.metallic_roughness.pixels[i * 3 + 1] = to_byte(t.roughness);
      set.metallic_roughness.pixels[i * 3 + 2] = to_byte(t.metallic);
      height[i] = static_cast<float>(t.height_m);
    }
  });
  const double texel_m = tile_m / size;
  tbb::parallel_for(0, size, [&](int y) {
    const auto at = [&](int px, int py) {
      return static_cast<double>(
          height[static_cast<std::size_t>((py + size) % size) * size + (px + size) % size]);
    };
    for (int x = 0; x < size; ++x) {
      const double nx = -(at(x + 1, y) - at(x - 1, y)) / (2 * texel_m);
      const double ny =
          (at(x, y + 1) - at(x, y - 1)) / (2 * texel_m);  // green points up in the image, rows run down
      const double scale = 0.5 / std::sqrt(nx * nx + ny * ny + 1);
      const std::size_t i = (static_cast<std::size_t>(y) * size + x) * 3;
      set.normal.pixels[i] = to_byte(0.5 + nx * scale);
      set.normal.pixels[i + 1] = to_byte(0.5 + ny * scale);
      set.normal.pixels[i + 2] = to_byte(0.5 + scale);
    }
  });
  return set;
}

}  // namespace cps::city
