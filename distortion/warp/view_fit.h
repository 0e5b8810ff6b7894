#pragma once

#include <string>

#include "distortion/calibrated_camera.h"
#include "distortion/pinhole.h"

/// Cameras that make the most of pictures that are there already: which part of them to show.
namespace cps {

/// A camera for the output, or why there is none.
struct ViewFit {
  bool valid = false;
  Pinhole camera;
  std::string why;  ///< of a refusal, one line
};

/// The camera of `wanted`, its focal lengths multiplied by the smallest zoom ≥ 1 with which a kernel of
/// `sigma_px` output pixels finds all it needs in an ideal picture taken at `source`: no black border, and
/// `wanted` itself where the picture shows enough. A zoom above `max_zoom`, and a lens of which no part is
/// one-to-one, are refused.
ViewFit fit_distorted_view(const Pinhole& source, const CalibratedCamera& wanted, double sigma_px,
                           double max_zoom);

/// What a straightened picture is to show.
enum class Keep {
  valid,   ///< as much as leaves no pixel without a source
  all,     ///< everything that the source shows, in a frame with black borders
  camera,  ///< the source's own camera matrix, like OpenCV's undistort: what is beyond the edge is lost
};

/// The camera of `width` × `height` pixels that straightens a picture taken by `source`. For Keep::valid and
/// Keep::all it has square pixels and a centred principal point. A lens that is not one-to-one on its whole
/// frame is straightened where it is. The kernel has `sigma_px` output pixels.
ViewFit fit_straight_view(const CalibratedCamera& source, Keep keep, int width, int height, double sigma_px);

}  // namespace cps
