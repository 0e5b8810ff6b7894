#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/city/draws.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/noise.h"

namespace cps::city {
namespace {

/// A leaf or needle on the card: base, direction (unit) and size, in card widths; v points down.
struct Blade {
  double u, v, du, dv, length, width, tone;
};

/// The topmost blade at (u, v), −1 if there is none, and the position along it (0 to 1) and across it (−1 to
/// 1).
struct BladeHit {
  int blade = -1;
  double along = 0, across = 0;
};

BladeHit find_blade(const std::vector<Blade>& blades, double u, double v) {
  for (int i = static_cast<int>(blades.size()) - 1; i >= 0; --i) {
    const Blade& b = blades[i];
    const double x = u - b.u, y = v - b.v;
    const double along = (x * b.du + y * b.dv) / b.length, across = x * -b.dv + y * b.du;
    if (along < 0 || along > 1) continue;
    const double half =
        b.width * std::sin(std::numbers::pi * std::pow(along, 0.8));  // widest nearer the base
    if (std::abs(across) < half) return {i, along, across / std::max(half, 1e-9)};
  }
  return {};
}

/// Whether the blade lies on the card with a margin. The texture repeats, so what crosses one edge would
/// reappear at the opposite one.
bool fits_card(const Blade& b) {
  constexpr double rim = 0.03;
  const double tip_u = b.u + b.du * b.length, tip_v = b.v + b.dv * b.length;
  return std::min({b.u, b.v, tip_u, tip_v}) > rim + b.width &&
         std::max({b.u, b.v, tip_u, tip_v}) < 1 - rim - b.width;
}

TextureSet paint_card(const std::vector<Blade>& blades, const std::array<double, 3>& color, double tile_m) {
  return paint(512, tile_m, true, [&](double u, double v) {
    const BladeHit hit = find_blade(blades, u, v);
    Texel t;
    t.roughness = 0.6;
    t.alpha = hit.blade >= 0 ? 1 : 0;
    const double tone = hit.blade >= 0 ? blades[hit.blade].tone : 1.0;
    const double vein = hit.blade >= 0 && std::abs(hit.across) < 0.07 ? 1.12 : 1.0;
    for (int c = 0; c < 3; ++c) t.color[c] = color[c] * tone * vein * (1 - 0.12 * std::abs(hit.across));
    t.height_m = hit.blade >= 0 ? 0.003 * (1 - hit.across * hit.across) : 0;
    return t;
  });
}

}  // namespace

TextureSet bark_texture(Stream stream) {
  return paint(512, bark_tile_m, false, [=](double u, double v) {
    const double wobble = 0.08 * fractal_noise(substream(stream, 1), u, v, 4, 3);
    const double ridge = std::abs(gradient_noise(substream(stream, 2), u + wobble, v * 0.25, 24));
    const double grain = fractal_noise(substream(stream, 3), u, v, 40, 3);
    const double light = 0.26 + 0.22 * ridge + 0.07 * grain;
    Texel t;
    t.color = {light * 1.06, light * 0.97, light * 0.86};
    t.height_m = 0.02 * ridge + 0.003 * grain;
    t.roughness = 0.95;
    return t;
  });
}

TextureSet birch_bark_texture(Stream stream) {
  return paint(512, bark_tile_m, false, [=](double u, double v) {
    const double grain = fractal_noise(substream(stream, 1), u, v, 24, 3);
    // Dark lenticels, short and across the stem, and a few black scars.
    const double wave = 0.02 * gradient_noise(substream(stream, 2), u, v, 6);
    const double dash = gradient_noise(substream(stream, 3), u * 0.25, v + wave, 48);
    const double scar = fractal_noise(substream(stream, 4), u, v, 5, 2);
    const bool dark = dash > 0.42 || scar > 0.52;
    const double light = (dark ? 0.16 : 0.80) + 0.06 * grain;
    Texel t;
    t.color = {light, light * 0.98, light * 0.93};
    t.height_m = 0.002 * grain - (dark ? 0.002 : 0);
    t.roughness = 0.85;
    return t;
  });
}

namespace {

/// The leaves of a twig: along side twigs of a central stem.
std::vector<Blade> draw_twig(Draws& draws, int side_twigs, int leaves_per_twig, double leaf_length,
                             double slenderness) {
  std::vector<Blade> leaves;
  for (int twig = 0; twig < side_twigs; ++twig) {
    const double start = 1.0 - twig * 0.91 / side_twigs;
    const double lean = draws.uniform(0.5, 1.3) * (twig % 2 ? 1 : -1);
    for (int k = 0; k < leaves_per_twig; ++k) {
      const double reach = 0.03 + 0.456 * k / leaves_per_twig;
      const double turn = lean + draws.uniform(-1.1, 1.1), size = leaf_length * draws.uniform(0.7, 1.1);
      const Blade leaf{0.5 + reach * std::sin(lean),
                       start - 0.12 - reach * std::cos(lean) * 0.8,
                       std::sin(turn),
                       -std::cos(turn),
                       size,
                       size * slenderness,
                       draws.uniform(0.72, 1.2)};
      if (fits_card(leaf)) leaves.push_back(leaf);
    }
  }
  return leaves;
}

}  // namespace

TextureSet leaf_texture(Stream stream) {
  Draws draws{stream};
  const double leaf_length = draws.uniform(0.11, 0.15), slenderness = draws.uniform(0.3, 0.42);
  const std::vector<Blade> leaves = draw_twig(draws, 13, 12, leaf_length, slenderness);
  const double autumn = draws.uniform(0, 1);
  return paint_card(leaves, {0.36 + 0.10 * autumn, 0.49 + 0.03 * autumn, 0.17}, 0.7);
}

TextureSet fine_leaf_texture(Stream stream) {
  Draws draws{stream};
  const std::vector<Blade> leaves =
      draw_twig(draws, 19, 20, draws.uniform(0.065, 0.085), draws.uniform(0.40, 0.5));
  const double warm = draws.uniform(0, 1);
  return paint_card(leaves, {0.40 + 0.08 * warm, 0.52, 0.20}, 0.7);
}

TextureSet needle_texture(Stream stream) {
  Draws draws{stream};
  std::vector<Blade> needles;
  for (int twig = 0; twig < 9; ++twig) {
    const double lean = (twig - 4) * 0.27, reach = 0.75 - 0.04 * std::abs(twig - 4);
    for (int k = 0; k < 42; ++k) {
      const double along = reach * (k + 1) / 42.0;
      const double u = 0.5 + along * std::sin(lean), v = 0.97 - along * std::cos(lean);
      const double turn = lean + (k % 2 ? 1 : -1) * draws.uniform(0.5, 0.9);
      const Blade needle{u, v, std::sin(turn), -std::cos(turn), 0.09, 0.008, draws.uniform(0.7, 1.25)};
      if (fits_card(needle)) needles.push_back(needle);
    }
  }
  return paint_card(needles, {0.20, 0.30, 0.16}, 0.7);
}

}  // namespace cps::city
