#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

/// Masts along streets, and the wires between them.
namespace cps::city {

enum class OverheadKind {
  none,
  telegraph,  ///< wooden masts along one kerb, with wires along the street
  span,       ///< steel masts in pairs, with a wire and a lamp across the street
  tram        ///< steel masts in pairs, for the wires over tram tracks (tram_wires.h)
};

/// A mast on the pavement of one side; its +x faces the carriageway.
struct Mast {
  Side side;
  Vec2 position;
  double heading_rad = 0;
};

/// The masts of a segment. With `span` and `tram`, the two masts of a pair follow each other.
struct Overhead {
  OverheadKind kind = OverheadKind::none;
  std::vector<Mast> masts;
};

Overhead overhead_along(const StreetNetwork& network, int segment, const CityOptions& options);

/// All wires of one street except tram wires, with the lamps on them. Masts are placed as models.
Mesh overhead_wires(const StreetNetwork& network, int street, const Materials& materials,
                    const CityOptions& options);

Mesh telegraph_mast(const Materials& materials);
Mesh span_mast(const Materials& materials);

}  // namespace cps::city
