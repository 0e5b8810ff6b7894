#pragma once

#include "scenes/city/buildings/doorway.h"
#include "scenes/city/buildings/facade.h"
#include "scenes/city/buildings/roof.h"

namespace cps::city {

enum class BuildingKind { house, tower, hall, garage };

/// What stands on a lot, before its facade is drawn.
struct BuildingPlan {
  BuildingKind kind = BuildingKind::house;
  Footprint footprint;
  int storeys = 3;
  bool shops = false;
  bool party_start = false, party_end = false;  ///< a neighbour is built onto that end: no windows there
  bool detached = false;                        ///< all sides are seen
  RoofKind roof = RoofKind::gable;
  bool gable_to_street = false;  ///< the ridge runs away from the street
  bool distant = false;          ///< never seen from near: windows without depth
  double rear_wing_m = 0;        ///< depth of a lower wing behind; 0: none
};

/// The building with its own draw of materials, rhythm and details.
Building building(const BuildingPlan& plan, const Materials& materials, Stream stream);

/// The kinds, each in a file of its own.
Building house(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building tower(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building hall(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building garage(const BuildingPlan& plan, const Materials& materials, Stream stream);

/// The plan of the rear wing, empty where there is none.
Polygon rear_wing(const BuildingPlan& plan);

}  // namespace cps::city
