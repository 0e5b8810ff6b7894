#pragma once

#include <optional>

#include "dataset/job/masters.h"
#include "sampler/lenses/lens_draw.h"

namespace cps {

/// How lenses are drawn for a kept master while training.
struct OnlineLensOptions {
  LensOptions lens;              ///< those of the dataset's recipe
  double undistorted_share = 0;  ///< share of the draws without distortion
  /// The focal length is drawn log-uniformly between that of the master's set divided by this factor and
  /// multiplied by it.
  double zoom = 1.3;
};

/// A certified lens and its border-free crop inside the master. Lens and H-FOV are drawn again as long as the
/// crop reaches beyond the base that the master was rendered for, or magnifies beyond the master's
/// resolution. A pure function of the arguments. Throws std::runtime_error with one line when no lens is
/// found.
DrawnLens draw_online_lens(const KeptMaster& master, const OnlineLensOptions& options, Stream stream);

}  // namespace cps
