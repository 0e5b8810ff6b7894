#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/noise.h"

namespace cps::city {
namespace {

/// A trapezoid wave of period 1: 1 on the share `flat` of it, with slanted flanks down to 0.
double trapezoid(double x, double flat) {
  const double d = std::abs(x - std::floor(x) - 0.5) * 2;  // 0 in the middle of the period
  return std::clamp((1 - d - (1 - flat) / 2) / 0.16 + 0.5, 0.0, 1.0);
}

}  // namespace

TextureSet curtain_wall_texture(Stream stream) {
  Draws draws{substream(stream, 0)};
  const double spandrel = draws.uniform(0.18, 0.34), mullion_m = draws.uniform(0.05, 0.09);
  return paint(1024, curtain_wall_tile_m, false, [=](double u, double v) {
    const double x = u * curtain_wall_panels, y = (1 - v) * curtain_wall_storeys;  // y up
    const int panel = static_cast<int>(x), storey = static_cast<int>(y);
    const double fx = x - panel, fy = y - storey;
    const double panel_m = curtain_wall_tile_m / curtain_wall_panels,
                 storey_m = curtain_wall_tile_m / curtain_wall_storeys;
    const double to_edge = std::min({fx * panel_m, (1 - fx) * panel_m, fy * storey_m, (1 - fy) * storey_m,
                                     std::abs(fy - spandrel) * storey_m});
    const Stream pane = substream(stream, 16 + panel + 64 * storey);
    const double tone = random_uniform(pane, 0), blind = random_uniform(pane, 1);
    const double lean_x = random_uniform(pane, 2) - 0.5, lean_y = random_uniform(pane, 3) - 0.5;
    Texel t;
    if (to_edge < mullion_m / 2) {
      t.color = {0.42, 0.43, 0.44};
      t.roughness = 0.45;
      t.height_m = 0.02;
      return t;
    }
    const bool is_spandrel = fy < spandrel;
    const double drawn = blind < 0.25 ? 0.35 + 1.4 * blind : 0;  // share of the pane behind a blind
    const bool is_blind = !is_spandrel && fy > 1 - drawn * (1 - spandrel);
    const double light = is_spandrel ? 0.42 : is_blind ? 0.62 : 0.52 + 0.16 * (tone - 0.5);
    t.color = {light, light, light};
    t.metallic = is_blind ? 0.15 : 0.55;  // coated glass reflects more than bare glass
    t.roughness = is_spandrel ? 0.12 : 0.06;
    t.height_m = 0.008 * (lean_x * fx + lean_y * fy);  // panes differ a little in tilt
    return t;
  });
}

TextureSet sheet_texture(Stream stream) {
  return paint(512, sheet_tile_m, false, [=](double u, double v) {
    const double rib = trapezoid(u * 10, 0.55);
    const double stain = fractal_noise(substream(stream, 1), u, v, 4, 4);
    const double streak = fractal_noise(substream(stream, 2), u, 0.3, 24, 3);
    const double seam = std::abs(v - 0.5) < 0.004 ? 1.0 : 0.0;
    const double light = 0.86 + 0.05 * stain + 0.04 * streak - 0.06 * (1 - rib) - 0.25 * seam;
    Texel t;
    t.color = {light, light, light};
    t.height_m = 0.03 * rib;
    t.roughness = 0.5 + 0.1 * stain;
    t.metallic = 0.1;
    return t;
  });
}

}  // namespace cps::city
