#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/evaluation/lens_errors.h"
#include "trainer/model/predictor.h"

namespace cps {

struct EvaluatedImage;

/// An error of a joint fit beside those of the single frames.
struct CameraError {
  double joint = 0;
  double single_mean = 0;  ///< mean of the single frames' errors
  double deviation = 0;    ///< standard deviation that the joint fit states; 0: it states none

  /// Whether the truth lies within so many standard deviations.
  bool is_within(double deviations) const { return joint <= deviations * deviation; }
};

/// What a network with a fit says of one camera from all its frames.
struct CameraEvaluation {
  std::string name;  ///< EvaluationImage::taken_by
  CalibratedCamera truth;
  Outputs predicted{};  ///< by the joint fit, raw
  int frames = 0, trusted_frames = 0;
  CameraError hfov_deg;         ///< |Δ H-FOV|, as labels have it
  CameraError k1;               ///< |Δ K1|, scaled by the half diagonal (TargetSpace::apparent)
  CameraError reprojection_px;  ///< of the frames that are cameras
};

/// fit_one_camera() for the images of each camera: those with one name (EvaluationImage::taken_by) and one
/// truth, in the order of their first image. `batch`: the images as the network takes them, in the same
/// order. Throws std::runtime_error with one line if the network's head has no fit.
std::vector<CameraEvaluation> evaluate_cameras(const Predictor& predictor,
                                               std::span<const EvaluatedImage> images,
                                               std::span<const BatchImage> batch);

/// A table with a line for each of the first cameras, and one for the mean of all. Empty without cameras.
std::string report(std::span<const CameraEvaluation> cameras);

nlohmann::ordered_json to_json(std::span<const CameraEvaluation> cameras);

}  // namespace cps
