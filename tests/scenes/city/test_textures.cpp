#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/city/materials/textures.h"
#include "scenes/city/noise.h"

using namespace cps;
using namespace cps::city;

TEST_CASE("noise repeats with its period and is continuous at the seam") {
  const Stream stream = make_stream(1, "noise");
  for (int i = 0; i < 200; ++i) {
    const double v = i / 200.0;
    CHECK(gradient_noise(stream, 0.37 + 1, v, 8) == Approx(gradient_noise(stream, 0.37, v, 8)).margin(1e-9));
    CHECK(fractal_noise(stream, 1e-7, v, 8, 4) ==
          Approx(fractal_noise(stream, 1 - 1e-7, v, 8, 4)).margin(1e-4));
    const CellularNoise a = cellular_noise(stream, 1e-7, v, 16), b = cellular_noise(stream, 1 - 1e-7, v, 16);
    CHECK(a.nearest == Approx(b.nearest).margin(1e-4));
    CHECK(a.nearest <= a.second);
  }
}

TEST_CASE("a normal map is that of its heights") {
  // Height 2 cm · sin(2πu) over a tile of one metre: slope 2π · 0.02 at u = 0.
  const TextureSet set = paint(256, 1.0, false, [](double u, double) {
    Texel t;
    t.height_m = 0.02 * std::sin(2 * M_PI * u);
    return t;
  });
  const double slope = 2 * M_PI * 0.02, x = -slope / std::hypot(slope, 1.0);
  CHECK(set.normal.pixels[0] == Approx(255 * (0.5 + 0.5 * x)).margin(1.5));
  CHECK(set.normal.pixels[1] == Approx(127.5).margin(1));
  CHECK(set.normal.pixels[2] == Approx(255 * (0.5 + 0.5 / std::hypot(slope, 1.0))).margin(1.5));
}

TEST_CASE("green in a normal map points up the image") {
  const TextureSet set = paint(64, 1.0, false, [](double, double v) {
    Texel t;
    t.height_m = v < 0.5 ? 0.1 * v : 0.1 * (1 - v);  // in the upper half it rises downwards
    return t;
  });
  CHECK(set.normal.pixels[(16 * 64 + 5) * 3 + 1] > 130);
  CHECK(set.normal.pixels[(48 * 64 + 5) * 3 + 1] < 125);
}

TEST_CASE("textures have enough texels per metre, and leaf cards are cut out with a clear margin") {
  const TextureSet asphalt = asphalt_texture(make_stream(3, "asphalt"));
  CHECK(asphalt.base_color.width / asphalt_tile_m >= 250);
  const auto texels_per_m = [](const TextureSet& set, double tile_m) {
    return set.base_color.width / tile_m;
  };
  CHECK(texels_per_m(paving_texture(make_stream(3, "paving")), paving_tile_m) >= 250);
  CHECK(texels_per_m(plaster_texture(make_stream(3, "plaster")), plaster_tile_m) >= 250);
  CHECK(texels_per_m(concrete_texture(make_stream(3, "concrete")), concrete_tile_m) >= 250);
  CHECK(texels_per_m(sheet_texture(make_stream(3, "sheet")), sheet_tile_m) >= 250);
  CHECK(texels_per_m(grass_texture(make_stream(3, "grass")), grass_tile_m) >= 250);
  double mean = 0;
  for (std::uint8_t p : asphalt.base_color.pixels) mean += p;
  mean /= static_cast<double>(asphalt.base_color.pixels.size());
  CHECK(mean > 85);  // sRGB; worn asphalt reflects about 0.1 to 0.25
  CHECK(mean < 150);

  for (const TextureSet& card :
       {leaf_texture(make_stream(3, "leaves")), fine_leaf_texture(make_stream(3, "leaves")),
        needle_texture(make_stream(3, "needles"))}) {
    REQUIRE(card.base_color.channels == 4);
    std::size_t solid = 0;
    const std::size_t texels = card.base_color.pixels.size() / 4;
    for (std::size_t i = 0; i < texels; ++i) solid += card.base_color.pixels[4 * i + 3] > 127;
    CHECK(solid > texels * 15 / 100);
    CHECK(solid < texels * 85 / 100);
    const int size = card.base_color.width;
    for (int i = 0; i < size; ++i) {  // no leaf is cut off or reappears at the opposite edge
      const auto alpha = [&](int row, int column) {
        return card.base_color.pixels[4 * (row * size + column) + 3];
      };
      CHECK(alpha(0, i) == 0);
      CHECK(alpha(size - 1, i) == 0);
      CHECK(alpha(i, 0) == 0);
      CHECK(alpha(i, size - 1) == 0);
    }
  }
}
