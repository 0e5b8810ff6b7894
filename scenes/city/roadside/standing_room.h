#pragma once

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/roadside/model_library.h"

namespace cps::city {

/// What stands on one block and along its kerbs.
struct StandingRoom {
  const BlockPlan& plan;
  std::vector<PlacedModel> placed = {};
  std::vector<Polygon> kept_free = {};  ///< for what comes later

  /// Puts it there unless it would stand in a house, in something else or on what is kept free.
  bool try_place(const PlacedModel& model);
};

}  // namespace cps::city
