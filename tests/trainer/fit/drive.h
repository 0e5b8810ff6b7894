#pragma once

#include "random/counter_hash.h"
#include "trainer/fit/one_camera.h"

/// Frames of one known camera, made by the model itself.
namespace cps {

/// The frames' picture.
inline constexpr ImageSize drive_picture{696, 256};

/// What the numbers read directly err by: standard deviations of the outputs, then those of the angles.
FitVector reading_deviation();

/// A camera that sees 60 to 90°, with a lens as cars have; its angles are 0.
FitVector drawn_camera(Stream stream);

struct FilmedDriveOptions {
  double common_share = .25;  ///< of the variance of what is read, as OneCameraOptions has it
  double edge_weight = 2500;  ///< see synthetic_evidence()
};

/// What a network could say of that many frames of the camera: normal errors of the numbers read, of which
/// common_share of the variance is the same in all frames; angles and tilts of edges of each frame's own.
std::vector<FrameEvidence> drive(const FitVector& camera, int frames, Stream stream,
                                 const FilmedDriveOptions& options = {});

/// Frames that say the camera without any error, all the same.
std::vector<FrameEvidence> exact_drive(const FitVector& camera, int frames, double edge_weight);

}  // namespace cps
