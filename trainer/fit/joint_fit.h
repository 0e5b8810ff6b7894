#pragma once

#include <span>
#include <vector>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/fit/lens_fit.h"

/// Frames of one camera: the eight outputs are common to all of them, pitch, roll and yaw are each frame's
/// own. Gauss and Newton's method, as for one frame. Each frame's angles are eliminated from its equations
/// (Schur complement), so that the cost is in proportion to the number of frames (Brown 1958; Triggs,
/// McLauchlan, Hartley, Fitzgibbon 2000).
namespace cps {

using OutputVector = Eigen::Matrix<double, output_count, 1>;

/// A frame as it counts in a joint fit.
struct WeighedFrame {
  FrameEvidence evidence;
  double weight = 1;  ///< factor on all its precisions
};

/// Equations of the outputs alone: information · step = pull.
struct OutputEquations {
  OutputCovariance information = OutputCovariance::Zero();  ///< inverse of a covariance
  OutputVector pull = OutputVector::Zero();
};

/// What a frame's equations say of the outputs when its angles are unknown.
OutputEquations without_angles(const EdgeEquations& frame);

/// The most probable parameters of all frames.
struct JointFit {
  std::vector<FitVector> parameters;  ///< of each frame; the outputs are the same in all
  OutputCovariance information;       ///< of the outputs: inverse of their covariance
};

/// Starts at the given parameters, one for each frame, whose outputs must be the same in all (not checked).
/// Ends when a step is below a hundredth of the standard deviations, or no step lowers the cost any more, or
/// after `max_iterations`. The H-FOV stays within fitted_hfov_rad. The same for any number of threads.
JointFit fit_jointly(std::span<const WeighedFrame> frames, std::vector<FitVector> start,
                     int max_iterations = 12);

}  // namespace cps
