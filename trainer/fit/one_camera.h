#pragma once

#include <span>
#include <string>
#include <vector>

#include "trainer/calibration/certified_lens.h"
#include "trainer/calibration/lens_posterior.h"
#include "trainer/fit/lens_fit.h"

/// One camera from the pictures that it took: fit_jointly() in rounds, between which blocks of edges and
/// whole frames that do not agree with the rest get less weight.
namespace cps {

/// A picture of the camera.
struct CameraFrame {
  FrameEvidence evidence;
  FitVector alone;  ///< parameters of fit_lens()
};

/// The frames with fit_lens() of each, on all cores.
std::vector<CameraFrame> fit_each(std::vector<FrameEvidence> frames);

struct OneCameraOptions {
  /// κ: the share of the variance of the directly read numbers that all frames of a camera have in common,
  /// because a network reads the same kind of street in each. The variance of the mean of N frames is then
  /// κ + (1 − κ) / N of a frame's, and not 1 / N. Errors of the edges count as independent.
  double common_share = .25;
  double degrees_of_freedom = 4;  ///< ν of student_weight(); fewer trust outliers less
  int rounds = 6;                 ///< in which weights are set and the camera is fitted; 0: all weights are 1
  /// Factors on the standard deviations that fits state: ModelCard::deviation_scale.
  Outputs deviation_scale{1, 1, 1, 1, 1, 1, 1, 1};

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// The camera's position in one frame, and how much the frame counts.
struct FrameInCamera {
  double pitch_rad = 0, roll_rad = 0, yaw_rad = 0;  ///< fit_parameters.h
  double weight = 1;                                ///< between 0 and 1
};

/// What all frames say together.
struct OneCamera {
  LensPosterior posterior;            ///< in TargetSpace::seen; the mean is pulled_to_one_to_one()
  CertifiedLens certified;            ///< pull_to_certified() of the mean; without a name
  std::vector<FrameInCamera> frames;  ///< in the order given
  /// robust_deviation() of the edges' tilts from the camera's, in the standard deviations that they state. 1
  /// where there were too few frames to judge edges.
  double tilt_scatter = 1;

  /// The frames that count at least half; the others are outliers.
  int trusted_frames() const;
};

/// Starts from the median of the frames' own outputs. In each round, blocks of edges are weighed by
/// weigh_down() in units of their tilt_scatter, and frames by student_weight() of the Mahalanobis distance
/// over the eight outputs between what the frame says alone, with the weighed blocks, and the camera. Fewer
/// than three frames outvote nobody: they all count in full. The result for one frame is that of fit_lens().
///
/// The order of the frames changes nothing but the last bits. There must be at least one, and all must be of
/// one size (not checked). Throws std::runtime_error with one line if the frames' numbers are not finite.
OneCamera fit_one_camera(std::span<const CameraFrame> frames, const OneCameraOptions& options = {});

}  // namespace cps
