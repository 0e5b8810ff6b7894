#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

inline constexpr double tram_gauge_m = 1.435;

/// The middle of one track, in driving direction, from end to end of its street.
struct TramTrack {
  int street = 0;
  Polyline centre;
};

/// Two for every street with tram tracks, one where it is a one-way street.
std::vector<TramTrack> tram_tracks(const StreetNetwork& network);

/// Rails set in the road, with their grooves.
Mesh tram_rails(const TramTrack& track, const Materials& materials);

}  // namespace cps::city
