#pragma once

#include <array>
#include <optional>

#include "distortion/crop/crop.h"
#include "distortion/crop/cropped_lens.h"
#include "numbers/interval.h"
#include "random/counter_hash.h"
#include "sampler/lenses/lens_options.h"

namespace cps {

/// Which H-FOV is given, and which follows from the crop.
enum class CropOrder {
  base_first,   ///< the base's (undistorted render) is given, the label's follows
  label_first,  ///< the label's is given, each lens gets a base of its own
};

/// A drawn lens: its coefficients, the camera to render for it, the final camera after the crop, and the
/// interval that each number was drawn from.
struct DrawnLens {
  Distortion distortion;
  Pinhole base;  ///< undistorted camera, output-sized and centred; the lens is certified on its frame
  Crop crop;
  /// In the order k1 k2 k3 p1 p2 cx cy. Empty for the undistorted lens, and for coefficients that a prior
  /// draws jointly.
  std::array<std::optional<Interval>, 7> limits;
};

/// The lens as photograph() takes it.
inline CroppedLens cropped(const DrawnLens& lens) {
  return {lens.distortion, lens.crop.camera, frame_on_plane(lens.base)};
}

/// Draws a lens for images of the camera's size. `camera` has square pixels and a centred principal point. It
/// is the base or, label-first, the final camera except for the principal point (its focal length is met to
/// 1e-9). The coefficients are drawn first, in units of the frame's half diagonal, independent of the H-FOV;
/// then cx and cy, in random order, uniform among the shifts that keep the crop's zoom below its cap. Every
/// lens keeps options.bounds on its base's frame, certificate included. A lens that does not, or whose crop
/// exceeds the zoom cap or the resolution of the warp's oversampling, is drawn again as a whole. Throws
/// std::runtime_error if the options leave no lens, or if they limit k1 label-first: k1 refers to the base,
/// which is then not given.
DrawnLens draw_lens(const Pinhole& camera, CropOrder order, const LensOptions& options, Stream stream);

/// No distortion, centred principal point, zoom 1: base and final camera are `camera`.
DrawnLens undistorted_lens(const Pinhole& camera);

}  // namespace cps
