#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sampler/plan/plan.h"

namespace cps {

/// Adds the groups of one set and camera to the plan as its views ask for them: the undistorted group, if the
/// recipe has it, and `lenses` groups for every block of `views_per_lens` views of each part.
class SetGroups {
 public:
  /// The groups and the master camera of views that share their lenses.
  struct Block {
    std::vector<int> groups;  ///< indices into plan.groups, the undistorted one first, if there is one
    Pinhole master;           ///< empty where lenses are of another family than Brown–Conrady
  };

  SetGroups(Plan& plan, int set, int camera);

  /// The block of the `rank_in_part`-th view of a part; draws its lenses if it is new.
  const Block& block_of(Part part, int rank_in_part);

 private:
  Block draw_block(Part part);
  Block draw_family_block(Part part);
  /// The number and the stream of a further lens with distortion.
  std::pair<int, Stream> next_lens();
  PlannedGroup& add(int lens_number, Part part);
  int last_group() const { return static_cast<int>(plan_.groups.size()) - 1; }

  Plan& plan_;
  int set_, camera_;
  int undistorted_ = -1;  ///< index of the undistorted group; -1: none
  std::map<std::pair<Part, int>, Block> blocks_;
};

}  // namespace cps
