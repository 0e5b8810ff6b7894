#pragma once

#include <optional>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/model_camera.h"

/// Cameras of any lens family by the horizontal angle that their pictures really show. A label's
/// 2·atan(W / 2fx) means little for a fisheye, and nothing for one that sees 180° or more.
namespace cps {

/// The angle between the rays through the left and the right end of the principal point's row, radians, as
/// seen_fov() has it, whatever the picture's corners see. Empty if an end of that row, one pixel high, lies
/// outside the region's image.
std::optional<double> seen_hfov_rad(const ModelCamera& camera, const RayRegion& region);

/// The camera of `width` × `height` square pixels with a centred principal point whose seen_hfov_rad() is
/// `hfov_rad` (to 1e-9), found by bisection; its name is empty. Empty if the lens is not proved one-to-one
/// that far out. The corners of the picture may lie beyond what the lens shows: certify_frame() tells.
std::optional<ModelCamera> camera_from_seen_hfov(const LensModel& lens, int width, int height,
                                                 double hfov_rad);

}  // namespace cps
