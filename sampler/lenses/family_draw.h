#pragma once

#include <string_view>

#include "distortion/image_size.h"
#include "distortion/models/model_camera.h"
#include "random/counter_hash.h"

namespace cps {

/// Draws a camera with a lens of a family other than Brown–Conrady, whose picture shows the angle `hfov_rad`
/// along its middle row (seen_hfov_rad(), to 1e-9). Square pixels, a centred principal point, no name. The
/// parameters come from draw_model_lens(). A lens is drawn again that is not proved one-to-one along the
/// whole row, or that is so coarse in the middle that a pixel there covers more than three times the angle of
/// the row's mean pixel, as only pinhole cameras beyond 152° do; the corners of the picture may lie beyond
/// what the lens shows. A pure function of the arguments. Throws std::runtime_error in one line: a family
/// without a prior, or no lens found in 1000 attempts.
ModelCamera draw_family_camera(std::string_view family, ImageSize size, double hfov_rad, Stream stream);

}  // namespace cps
