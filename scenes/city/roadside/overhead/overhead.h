#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

/// Masts along the streets and the wires between them.
namespace cps::city {

enum class OverheadKind {
  none,
  telegraph,  ///< wooden masts along one kerb, wires from each to the next
  span,       ///< steel masts in pairs, a wire across the street with a lamp in its middle
  tram        ///< such masts too, for what hangs over tram tracks (tram_wires.h)
};

/// A mast on the pavement of one side; +x faces the carriageway.
struct Mast {
  Side side;
  Vec2 position;
  double heading_rad = 0;
};

/// What a segment of street has: of `span` and `tram`, the masts of a pair follow each other.
struct Overhead {
  OverheadKind kind = OverheadKind::none;
  std::vector<Mast> masts;
};

Overhead overhead_along(const StreetNetwork& network, int segment, const CityOptions& options);

/// All wires of one street but a tram's, with the lamps that hang from them; the masts are models.
Mesh overhead_wires(const StreetNetwork& network, int street, const Materials& materials,
                    const CityOptions& options);

Mesh telegraph_mast(const Materials& materials);
Mesh span_mast(const Materials& materials);

}  // namespace cps::city
