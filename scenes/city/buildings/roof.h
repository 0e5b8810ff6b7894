#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/geometry/footprint.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

enum class RoofKind { flat, gable, hip, mansard, sawtooth };

/// Height of a flat roof's parapet above the last ceiling.
inline constexpr double parapet_m = 0.5;

struct RoofPlan {
  RoofKind kind = RoofKind::gable;
  double pitch_deg = 40;
  bool free_start = false, free_end = false;  ///< no neighbour at that end: the roof projects
  WallMaterial wall;                          ///< of gables
  bool dormers = false;
  MaterialId cover = 0;     ///< of slopes
  bool lived_under = true;  ///< has chimneys, attic windows or stair heads
};

/// Adds a sawtooth roof over a two-point footprint; each tooth has a glazed face and a slope. Returns the
/// height of its highest point.
double add_sawtooth(Mesh& mesh, const Footprint& footprint, double eaves, const RoofPlan& plan,
                    const Materials& materials);

/// Adds the roof over a footprint whose walls end at height `eaves`. Returns the height of its highest point.
double add_roof(Mesh& mesh, const Footprint& footprint, double eaves, const RoofPlan& plan,
                const Materials& materials, Draws& draws);

}  // namespace cps::city
