#pragma once

#include <optional>

#include "dataset/job/masters.h"
#include "sampler/lenses/lens_draw.h"

namespace cps {

/// What lenses are drawn for a kept master while training.
struct OnlineLensOptions {
  LensOptions lens;              ///< as the dataset's recipe has them
  double undistorted_share = 0;  ///< of the draws that have no lens
  /// The H-FOV is drawn about that of the master's set: focal length log-uniform between this factor and its
  /// inverse.
  double zoom = 1.3;
};

/// A certified lens and its border-free crop inside the master: drawn again, H-FOV and all, while it reaches
/// beyond the base that the master was made for, or enlarges more than the master carries. A pure function of
/// the arguments. Throws std::runtime_error with one line when none is found.
DrawnLens draw_online_lens(const KeptMaster& master, const OnlineLensOptions& options, Stream stream);

}  // namespace cps
