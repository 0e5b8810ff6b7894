#pragma once

#include <string>

#include "distortion/models/model_camera.h"

namespace cps {

/// Throws std::runtime_error `<where>: <field>: …` for a camera that no lens and no sensor can be, whatever
/// its file's format: absurd sizes, focal lengths outside 1/1000 to 1000 image widths, a principal point
/// outside the image, parameters that are not finite or outside the family's range, coefficients that move
/// the image's corner by more than 100 radii.
void check_plausible(const ModelCamera& camera, const std::string& where);

}  // namespace cps
