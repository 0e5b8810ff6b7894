#pragma once

#include <vector>

#include "numbers/angles.h"
#include "numbers/interval.h"
#include "trainer/fit/edge_blocks.h"
#include "trainer/fit/fit_parameters.h"

/// A camera from the edges of one picture and what else is known of it: the most probable parameters under a
/// normal prior, where the tilt of a block's edges is that of edge_tilts() with a normal error whose
/// precision is the block's weight (maximum a posteriori, by Gauss and Newton's method).
namespace cps {

/// A normal distribution.
struct LensPrior {
  FitVector mean;
  FitMatrix precision;  ///< inverse of the covariance
};

/// What one picture says of its camera: numbers read directly, and its edges.
struct FrameEvidence {
  LensPrior prior;
  EdgeBlocks edges;      ///< in fit_grid(); the weights are precisions
  BlockCentres centres;  ///< of its grid
};

/// The tilts of a picture's blocks by a camera, and their slopes; in the order of EdgeBlocks.
struct TiltModel {
  std::vector<double> tilt;   ///< 0 where it has none
  std::vector<double> slope;  ///< fit_parameter_count for each block; zeros where it has no tilt
  std::vector<bool> has_tilt;
};

/// The model's tilts for the parameters, at the centres of the blocks.
TiltModel tilt_model(const FrameEvidence& frame, const FitVector& parameters);

/// The Gauss–Newton equations of the edges at some parameters: information · step = pull.
struct EdgeEquations {
  FitMatrix information = FitMatrix::Zero();  ///< Σ weight · slope slopeᵀ
  FitVector pull =
      FitVector::Zero();  ///< Σ (weighted tilt − weight · model tilt) · slope  /// ½ Σ weight · (tilt − model
                          ///< tilt)², less a constant of the picture. A block without a model tilt counts as
  /// one whose model tilt is ±1, on the wrong side, so that losing a block never pays.
  double cost = 0;
};
EdgeEquations edge_equations(const FrameEvidence& frame, const TiltModel& model);

/// edge_equations() at some parameters, with the frame's prior in all three members. `model` is the frame's
/// tilt_model() there, which the second form computes.
EdgeEquations frame_equations(const FrameEvidence& frame, const FitVector& parameters,
                              const TiltModel& model);
EdgeEquations frame_equations(const FrameEvidence& frame, const FitVector& parameters);

/// The most probable parameters.
struct LensFit {
  FitVector parameters;
  FitMatrix information;  ///< inverse of the covariance
  TiltModel model;        ///< at the parameters
  int iterations = 0;
};

/// Within which a fit keeps the H-FOV that is seen, radians.
inline constexpr Interval fitted_hfov_rad{radians(5), radians(170)};

/// The parameters with the H-FOV clamped to that.
FitVector within_bounds(FitVector parameters);

/// Starts at the prior's mean. Ends when a step is below a thousandth of the standard deviations, or no step
/// lowers the cost any more, or after `max_iterations`. The H-FOV stays within fitted_hfov_rad.
LensFit fit_lens(const FrameEvidence& frame, int max_iterations = 12);

}  // namespace cps
