#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/kerb_side.h"

/// Cycle tracks on the pavements, behind lamps and trees, where the street's profile has them.
namespace cps::city {

/// From the kerb to the track's near edge.
inline constexpr double pavement_track_inset_m = 1.45;
/// The track lies this much above the paving, as pads do.
inline constexpr double pavement_track_rise_m = 0.012;

/// The track's middle line along one side, in driving direction; empty where there is none.
Polyline pavement_track(const StreetNetwork& network, const KerbSide& kerb);

/// The tracks of one street: red asphalt with bicycles painted on it.
Mesh pavement_tracks(const StreetNetwork& network, int street, const Materials& materials,
                     const CityOptions& options);

}  // namespace cps::city
