#pragma once

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/roadside/model_library.h"

namespace cps::city {

/// The models placed on a block and along its kerbs so far.
struct StandingRoom {
  const BlockPlan& plan;
  std::vector<PlacedModel> placed = {};
  std::vector<Polygon> kept_free = {};  ///< ground reserved for later models

  /// Places the model, unless it would overlap a building, another model or ground kept free. Returns whether
  /// it did.
  bool try_place(const PlacedModel& model);
};

}  // namespace cps::city
