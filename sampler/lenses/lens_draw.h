#pragma once

#include <array>
#include <optional>

#include "distortion/crop/crop.h"
#include "distortion/crop/cropped_lens.h"
#include "numbers/interval.h"
#include "random/counter_hash.h"
#include "sampler/lenses/lens_options.h"

namespace cps {

/// Which H-FOV is fixed, and which follows from the crop.
enum class CropOrder {
  base_first,   ///< the undistorted render's; the label's follows
  label_first,  ///< the label's; each lens has a base of its own
};

/// A lens as drawn: its coefficients, what must be rendered for it, the final camera its crop gives, and the
/// interval each number came from.
struct DrawnLens {
  Distortion distortion;
  Pinhole base;  ///< output-sized and centred: the undistorted camera on whose frame the lens is certified
  Crop crop;
  /// In the order k1 k2 k3 p1 p2 cx cy. Empty for the undistorted lens, and for coefficients that were drawn
  /// jointly, from a prior.
  std::array<std::optional<Interval>, 7> limits;
};

/// The lens as photograph() takes it.
inline CroppedLens cropped(const DrawnLens& lens) {
  return {lens.distortion, lens.crop.camera, frame_on_plane(lens.base)};
}

/// A lens for images of the camera's size. `camera` has square pixels and a centred principal point; it is
/// the base, or, label-first, the final camera but for its principal point (its focal length holds to 1e-9).
/// First the coefficients, in units of the frame's half diagonal, so that they know nothing of the H-FOV;
/// then cx and cy, in random order, uniform inside the shifts that keep the crop's zoom below its cap. Every
/// lens is within options.bounds on its base's frame, certificate included. One that is not, or whose crop
/// exceeds the zoom cap or what the warp's oversampling carries, is drawn again as a whole. Throws
/// std::runtime_error when the options leave no lens, or limit k1, which is told on the base's plane z = 1,
/// where no base is given.
DrawnLens draw_lens(const Pinhole& camera, CropOrder order, const LensOptions& options, Stream stream);

/// No distortion, centred principal point, zoom 1: base and final camera are `camera`.
DrawnLens undistorted_lens(const Pinhole& camera);

}  // namespace cps
