#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sampler/plan/plan.h"

namespace cps {

/// Adds one set's and camera's groups to the plan as its views ask for them: the undistorted one if the
/// recipe wants it, and `lenses` of its own for every block of `views_per_lens` views of each part.
class SetGroups {
 public:
  /// What views share that are seen through the same lenses.
  struct Block {
    std::vector<int> groups;  ///< indices into plan.groups, the undistorted one first, if there is one
    Pinhole master;
  };

  SetGroups(Plan& plan, int set, int camera);

  /// The block of the part's `rank_in_part`-th view.
  const Block& block_of(Part part, int rank_in_part);

 private:
  Block draw_block(Part part);
  int add(int lens_number, Part part, const DrawnLens& lens);

  Plan& plan_;
  int set_, camera_;
  int undistorted_ = -1;  ///< -1: none
  std::map<std::pair<Part, int>, Block> blocks_;
};

}  // namespace cps
