#pragma once

#include <string>

#include "distortion/calibrated_camera.h"
#include "distortion/pinhole.h"

/// Output cameras for existing pictures: which part of a picture to show when it is distorted or
/// straightened.
namespace cps {

/// The camera of the output, or the reason why there is none.
struct ViewFit {
  bool valid = false;
  Pinhole camera;
  std::string why;  ///< of a refusal, one line
};

/// The camera of `wanted`, its focal lengths multiplied by the smallest zoom ≥ 1 with which a kernel of
/// `sigma_px` output pixels lies inside an ideal picture taken at `source` everywhere: no black border, and
/// `wanted` itself where the picture shows enough. Refuses a zoom above `max_zoom`, and a lens that is
/// one-to-one on no part of the frame.
ViewFit fit_distorted_view(const Pinhole& source, const CalibratedCamera& wanted, double sigma_px,
                           double max_zoom);

/// What a straightened picture shows.
enum class Keep {
  valid,   ///< as much as leaves no pixel without a source
  all,     ///< everything that the source shows, in a frame with black borders
  camera,  ///< the source's own camera matrix, like OpenCV's undistort: content beyond the edge is lost
};

/// The camera of `width` × `height` pixels that straightens a picture taken by `source`. For Keep::valid and
/// Keep::all it has square pixels and a centred principal point. A picture whose lens is not one-to-one on
/// the whole frame is straightened where it is one-to-one. The kernel's standard deviation is `sigma_px`
/// output pixels.
ViewFit fit_straight_view(const CalibratedCamera& source, Keep keep, int width, int height, double sigma_px);

}  // namespace cps
