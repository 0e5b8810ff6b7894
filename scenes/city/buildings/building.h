#pragma once

#include "scenes/city/buildings/doorway.h"
#include "scenes/city/buildings/facade.h"
#include "scenes/city/buildings/roof.h"

namespace cps::city {

enum class BuildingKind { house, tower, hall, garage };

/// A building before its materials and details are drawn.
struct BuildingPlan {
  BuildingKind kind = BuildingKind::house;
  Footprint footprint;
  int storeys = 3;
  bool shops = false;
  bool party_start = false, party_end = false;  ///< a neighbour adjoins that end: no windows
  bool detached = false;                        ///< all sides are visible
  RoofKind roof = RoofKind::gable;
  bool gable_to_street = false;  ///< the ridge is at right angles to the street
  bool distant = false;          ///< never seen from near: windows are flat
  double rear_wing_m = 0;        ///< depth of a lower wing behind the house; 0: none
};

/// Builds the mesh, with materials and details drawn from `stream`.
Building building(const BuildingPlan& plan, const Materials& materials, Stream stream);

/// The same for one kind each.
Building house(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building tower(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building hall(const BuildingPlan& plan, const Materials& materials, Stream stream);
Building garage(const BuildingPlan& plan, const Materials& materials, Stream stream);

/// The ground plan of the rear wing; empty without one.
Polygon rear_wing(const BuildingPlan& plan);

}  // namespace cps::city
