#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

inline constexpr double tram_gauge_m = 1.435;

/// The middle line of a tram track, in driving direction, over its whole street.
struct TramTrack {
  int street = 0;
  Polyline centre;
};

/// The tracks of all streets that have them: one per direction of traffic.
std::vector<TramTrack> tram_tracks(const StreetNetwork& network);

/// The rails of a track, set in the road, with their grooves.
Mesh tram_rails(const TramTrack& track, const Materials& materials);

}  // namespace cps::city
