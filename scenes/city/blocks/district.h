#pragma once

#include <array>

#include "scenes/city/city_options.h"
#include "scenes/city/geometry/plan_geometry.h"

namespace cps::city {

/// A district's character, which all its blocks share.
struct CityCharacter {
  double closed = 0, detached = 0, slabs = 0, park = 0, towers = 0,
         halls = 0;  ///< relative shares of block kinds
  double mean_storeys = 3.5, shop_share = 0.3, flat_roof_share = 0.3, tree_density = 1;
};

/// Draws the character of a district of that style (not `mixed`).
CityCharacter draw_character(std::uint64_t seed, CityStyle style = CityStyle::european);

/// The districts of a city: one, or for the mixed style several around sites.
struct Districts {
  struct Site {
    Vec2 position;
    CityStyle style;
  };
  std::vector<Site> sites;  ///< a point belongs to the nearest site
  std::array<CityCharacter, 4> characters;

  CityStyle style_at(const Vec2& point) const;
  const CityCharacter& character_at(const Vec2& point) const {
    return characters[static_cast<std::size_t>(style_at(point))];
  }
};

Districts draw_districts(const CityOptions& options);

}  // namespace cps::city
