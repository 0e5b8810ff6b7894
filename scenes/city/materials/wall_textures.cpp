#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/draws.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/noise.h"

namespace cps::city {
TextureSet brick_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  constexpr int columns = 8, rows = 26;  // 250 × 77 mm with the joint
  const bool yellow = draws.chance(0.25);
  const std::array<double, 3> clay =
      yellow ? std::array<double, 3>{0.66, 0.55, 0.38}
             : std::array<double, 3>{draws.uniform(0.48, 0.60), draws.uniform(0.26, 0.34),
                                     draws.uniform(0.19, 0.26)};
  const double spread = draws.uniform(0.06, 0.14), mortar = draws.uniform(0.48, 0.66);
  return paint(1024, brick_tile_m, false, [=](double u, double v) {
    const int row = static_cast<int>(v * rows);
    const double x = u * columns + (row % 2 ? 0.5 : 0.0);
    const int column = static_cast<int>(x) % columns;
    const double dx = std::min(x - std::floor(x), 1 - x + std::floor(x)) * brick_tile_m / columns;
    const double dy = std::min(v * rows - row, 1 - v * rows + row) * brick_tile_m / rows;
    const double grain = fractal_noise(substream(stream, 2), u, v, 90, 3);
    const double face = std::clamp((std::min(dx, dy) + 0.001 * grain - 0.004) / 0.004, 0.0, 1.0);
    const double tone = spread * 2 * (random_uniform(substream(stream, 1), column + 64 * row) - 0.5);
    const double dirt = fractal_noise(substream(stream, 3), u, v, 3, 4);
    Texel t;
    for (int c = 0; c < 3; ++c)
      t.color[c] =
          (clay[c] * (1 + tone) + 0.04 * grain) * face + (mortar + 0.05 * grain) * (1 - face) + 0.03 * dirt;
    t.height_m = 0.006 * face + 0.0007 * grain;
    t.roughness = 0.85 + 0.1 * (1 - face);
    return t;
  });
}

TextureSet plaster_texture(Stream stream) {
  return paint(512, plaster_tile_m, false, [=](double u, double v) {
    const double grain = fractal_noise(substream(stream, 1), u, v, 120, 2);
    const double trowel = fractal_noise(substream(stream, 2), u, v, 10, 4);
    const double streak = fractal_noise(substream(stream, 3), u, v * 0.0 + 0.3, 16, 3) *
                          (0.6 + 0.4 * fractal_noise(substream(stream, 4), u, v, 3, 2));
    const double light = 0.90 + 0.025 * grain + 0.03 * trowel + 0.035 * streak;
    Texel t;
    t.color = {light, light, light * 0.99};
    t.height_m = 0.0012 * grain + 0.001 * trowel;
    t.roughness = 0.9;
    return t;
  });
}

TextureSet concrete_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const double base = draws.uniform(0.66, 0.78);
  return paint(512, concrete_tile_m, false, [=](double u, double v) {
    const double grain = fractal_noise(substream(stream, 1), u, v, 100, 3);
    const double cloud = fractal_noise(substream(stream, 2), u, v, 4, 5);
    const CellularNoise pore = cellular_noise(substream(stream, 3), u, v, 60);
    const double hole = pore.nearest < 0.09 ? 1.0 : 0.0;
    const double joint_u = std::abs(u - 0.5) < 0.0025, joint_v = std::abs(v - 0.5) < 0.0025;
    const double joint = std::max(joint_u, joint_v);
    const double light = base + 0.035 * grain + 0.06 * cloud - 0.12 * hole - 0.2 * joint;
    Texel t;
    t.color = {light, light, light * 0.98};
    t.height_m = 0.0006 * grain - 0.002 * hole - 0.006 * joint;
    t.roughness = 0.82;
    return t;
  });
}

TextureSet roof_tile_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  constexpr int columns = 10, rows = 8;  // 240 × 300 mm visible
  const double kind = draws.uniform(0, 1);
  const std::array<double, 3> clay = kind < 0.55  ? std::array<double, 3>{0.56, 0.30, 0.20}
                                     : kind < 0.8 ? std::array<double, 3>{0.42, 0.26, 0.20}
                                                  : std::array<double, 3>{0.30, 0.31, 0.33};
  return paint(1024, roof_tile_m, false, [=](double u, double v) {
    const double x = u * columns, y = v * rows;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double fx = x - column, fy = y - row;  // fy grows down the slope
    const double tone = random_uniform(substream(stream, 1), column + 64 * row) - 0.5;
    const double grain = fractal_noise(substream(stream, 2), u, v, 60, 3);
    const double moss = fractal_noise(substream(stream, 3), u, v, 4, 4);
    const double gap = fy > 0.95 ? 0.55 : 1.0;  // shadow under the next tile's edge
    Texel t;
    for (int c = 0; c < 3; ++c)
      t.color[c] = clay[c] * (1 + 0.25 * tone + 0.12 * grain - 0.25 * std::max(0.0, moss)) * gap;
    t.height_m = 0.02 * std::sin(2 * std::numbers::pi * fx) + 0.02 * fy;
    t.roughness = 0.8;
    return t;
  });
}

TextureSet flat_roof_texture(Stream stream) {
  return paint(512, flat_roof_tile_m, false, [=](double u, double v) {
    const CellularNoise gravel = cellular_noise(substream(stream, 1), u, v, 100);
    const double cloud = fractal_noise(substream(stream, 2), u, v, 4, 4);
    const double light = 0.42 + 0.12 * (gravel.uniform() - 0.5) + 0.06 * cloud - 0.1 * gravel.nearest;
    Texel t;
    t.color = {light, light, light * 0.97};
    t.height_m = 0.008 * (1 - gravel.nearest);
    t.roughness = 0.95;
    return t;
  });
}

}  // namespace cps::city
