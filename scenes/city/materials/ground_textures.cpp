#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/noise.h"

namespace cps::city {
namespace {

std::array<double, 3> gray(double x) {
  return {x, x, x};
}

}  // namespace

TextureSet asphalt_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const double base = draws.uniform(0.47, 0.58), warmth = draws.uniform(-0.012, 0.012);
  return paint(1024, asphalt_tile_m, false, [=](double u, double v) {
    const CellularNoise stone = cellular_noise(substream(stream, 1), u, v, 230);  // 13 mm aggregate
    const double face = std::clamp((stone.second - stone.nearest) * 2.2, 0.0, 1.0);
    const double blotch = fractal_noise(substream(stream, 2), u, v, 5, 4);
    const double shade = (stone.uniform() - 0.5) * 0.15 * face;
    const double light = base + 0.05 * blotch + shade - 0.10 * (1 - face);
    Texel t;
    t.color = {light + warmth, light + 0.4 * warmth, light};
    t.height_m = 0.0016 * face + 0.001 * blotch;
    t.roughness = 0.88;
    return t;
  });
}

TextureSet paving_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const bool slabs = draws.chance(0.6);
  const int columns = slabs ? draws.one_of<int>({6, 8}) : 12, rows = slabs ? columns : 24;
  const double base = draws.uniform(0.50, 0.62), warmth = draws.uniform(-0.01, 0.05);
  const bool bond = !slabs || draws.chance(0.5);
  return paint(1024, paving_tile_m, false, [=](double u, double v) {
    const int row = static_cast<int>(v * rows);
    const double x = u * columns + (bond && row % 2 ? 0.5 : 0.0);
    const int column = static_cast<int>(x) % columns;
    const double dx = std::min(x - std::floor(x), 1 - x + std::floor(x)) * paving_tile_m / columns;
    const double dy = std::min(v * rows - row, 1 - v * rows + row) * paving_tile_m / rows;
    const double edge = std::min(dx, dy);
    const double joint = std::clamp((edge - 0.002) / 0.004, 0.0, 1.0);
    const double tone = random_uniform(substream(stream, 1), column + 64 * row) - 0.5;
    const double grain = fractal_noise(substream(stream, 2), u, v, 60, 3);
    const double stain = fractal_noise(substream(stream, 3), u, v, 4, 4);
    const double light = (base + 0.07 * tone + 0.05 * grain + 0.05 * stain) * joint + 0.30 * (1 - joint);
    Texel t;
    t.color = {light + warmth, light + 0.5 * warmth, light - 0.5 * warmth};
    t.height_m = 0.004 * joint + 0.0004 * grain + 0.0015 * tone;
    t.roughness = 0.85;
    return t;
  });
}

TextureSet kerb_texture(Stream stream) {
  return paint(512, kerb_tile_m, false, [=](double u, double v) {
    const int stone = static_cast<int>(u * 2);
    const double x = u * 2 - stone;
    const double joint = std::clamp((std::min(x, 1 - x) - 0.004) / 0.006, 0.0, 1.0);
    const double tone = random_uniform(substream(stream, 0), stone) - 0.5;
    const double grain = fractal_noise(substream(stream, 1), u, v, 64, 3);
    const double stain = fractal_noise(substream(stream, 2), u, v, 6, 3);
    Texel t;
    t.color = gray((0.60 + 0.06 * tone + 0.06 * grain + 0.06 * stain) * joint + 0.3 * (1 - joint));
    t.height_m = 0.003 * joint + 0.0006 * grain;
    t.roughness = 0.8;
    return t;
  });
}

TextureSet grass_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const double dry = draws.uniform(0.0, 0.6);
  return paint(512, grass_tile_m, false, [=](double u, double v) {
    const double blades = gradient_noise(substream(stream, 1), u, v, 110);
    const double fine = gradient_noise(substream(stream, 2), u, v, 220);
    const double clump = fractal_noise(substream(stream, 3), u, v, 6, 4);
    const double light = 0.75 + 0.35 * blades + 0.2 * fine + 0.3 * clump;
    const double d = std::clamp(dry + 0.6 * clump, 0.0, 1.0);
    Texel t;
    t.color = {(0.27 + 0.20 * d) * light, (0.36 + 0.08 * d) * light, (0.13 + 0.08 * d) * light};
    t.height_m = 0.012 * blades + 0.006 * fine;
    t.roughness = 0.95;
    return t;
  });
}

TextureSet road_paint_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const double wear = draws.uniform(0.0, 0.5);
  return paint(512, paint_tile_m, false, [=](double u, double v) {
    const double grain = fractal_noise(substream(stream, 1), u, v, 100, 3);
    const double stain = fractal_noise(substream(stream, 2), u, v, 7, 5);
    const double worn = std::clamp((stain + 0.7 * grain + wear - 0.75) * 2.0, 0.0, 0.6);
    Texel t;
    const double light = 0.82 + 0.05 * grain + 0.04 * stain;
    t.color = gray(light * (1 - worn) + 0.45 * worn);
    t.height_m = 0.0006 * grain;
    t.roughness = 0.6 + 0.3 * worn;
    return t;
  });
}

}  // namespace cps::city
