#include "scenes/city/blocks/district.h"

#include <algorithm>

#include "scenes/city/draws.h"

namespace cps::city {

CityCharacter draw_character(std::uint64_t seed, CityStyle style) {
  Draws draws{make_stream(seed, "character")};
  CityCharacter c;
  switch (style) {
    case CityStyle::downtown:
      c.towers = draws.uniform(1.0, 2.0);
      c.closed = draws.uniform(0.2, 0.8);
      c.slabs = draws.uniform(0.0, 0.15);
      c.park = draws.uniform(0.05, 0.2);
      c.mean_storeys = draws.uniform(5.0, 6.5);
      c.shop_share = draws.uniform(0.5, 0.9);
      c.flat_roof_share = draws.uniform(0.5, 0.9);
      c.tree_density = draws.uniform(0.4, 1.1);
      break;
    case CityStyle::suburb:
      c.detached = draws.uniform(1.5, 2.5);
      c.slabs = draws.uniform(0.0, 0.2);
      c.park = draws.uniform(0.1, 0.3);
      c.mean_storeys = draws.uniform(1.3, 2.2);
      c.shop_share = 0.05;
      c.flat_roof_share = draws.uniform(0.0, 0.2);
      c.tree_density = draws.uniform(0.8, 1.6);
      break;
    case CityStyle::industrial:
      c.halls = draws.uniform(2.0, 3.0);
      c.slabs = draws.uniform(0.0, 0.25);
      c.closed = draws.uniform(0.0, 0.2);
      c.detached = draws.uniform(0.0, 0.15);
      c.mean_storeys = draws.uniform(2.0, 3.5);
      c.flat_roof_share = draws.uniform(0.5, 0.9);
      c.tree_density = draws.uniform(0.3, 0.8);
      break;
    case CityStyle::european:
    case CityStyle::mixed:
      c.closed = draws.uniform(0.6, 2.0);
      c.detached = draws.uniform(0.1, 1.5);
      c.slabs = draws.uniform(0.0, 0.6);
      c.park = draws.uniform(0.05, 0.3);
      c.mean_storeys = draws.uniform(2.4, 5.1);
      c.shop_share = draws.uniform(0.1, 0.5);
      c.flat_roof_share = draws.uniform(0.05, 0.6);
      c.tree_density = draws.uniform(0.4, 1.5);
      break;
  }
  return c;
}

CityStyle Districts::style_at(const Vec2& point) const {
  return std::min_element(sites.begin(), sites.end(),
                          [&](const Site& a, const Site& b) {
                            return (a.position - point).squaredNorm() < (b.position - point).squaredNorm();
                          })
      ->style;
}

Districts draw_districts(const CityOptions& options) {
  Districts districts;
  for (int i = 0; i < 4; ++i)
    districts.characters[i] = draw_character(options.seed, static_cast<CityStyle>(i));
  if (options.style != CityStyle::mixed) {
    districts.sites.push_back({{0, 0}, options.style});
    return districts;
  }
  // Two sites per style: towers near the middle, factories and houses further out.
  Draws draws{make_stream(options.seed, "districts")};
  for (const auto& [style, reach] : {std::pair{CityStyle::downtown, 0.25},
                                     {CityStyle::european, 0.45},
                                     {CityStyle::suburb, 0.5},
                                     {CityStyle::industrial, 0.5}})
    for (int i = 0; i < 2; ++i) {
      const double x = draws.uniform(-reach, reach), y = draws.uniform(-reach, reach);
      districts.sites.push_back({Vec2(x, y) * options.extent_m, style});
    }
  return districts;
}

}  // namespace cps::city
