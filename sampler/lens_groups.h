#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sampler/plan.h"

namespace cps {

/// Adds one set's groups to the plan as its views ask for them: the undistorted one, and `lenses` of its own
/// for every block of `views_per_lens` views of each part.
class SetGroups {
 public:
  SetGroups(Plan& plan, int set);

  /// The groups (indices into plan.groups, the undistorted one first) of the part's `rank_in_part`-th view.
  std::vector<int> groups_for(Part part, int rank_in_part);

 private:
  int add(int lens_number, Part part, const DrawnLens& lens);

  Plan& plan_;
  int set_;
  int undistorted_;
  std::map<std::pair<Part, int>, std::vector<int>> blocks_;
};

}  // namespace cps
