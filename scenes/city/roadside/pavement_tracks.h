#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/kerb_side.h"

/// Cycle tracks on pavements, behind lamps and trees, for streets whose profile has them.
namespace cps::city {

/// Distance from the kerb to the track's near edge.
inline constexpr double pavement_track_inset_m = 1.45;
/// Height of the track above the paving, that of pads.
inline constexpr double pavement_track_rise_m = 0.012;

/// The middle line of the track along one side, in driving direction; empty without a track.
Polyline pavement_track(const StreetNetwork& network, const KerbSide& kerb);

/// The tracks of one street: red asphalt with bicycle symbols.
Mesh pavement_tracks(const StreetNetwork& network, int street, const Materials& materials,
                     const CityOptions& options);

}  // namespace cps::city
