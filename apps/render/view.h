#pragma once

#include <Eigen/Geometry>

#include "apps/render/request.h"
#include "scenes/scene.h"

namespace cps {

/// The ideal camera that was asked for: size, field of view and place, from the options, else from the glTF
/// camera that they name, else a view of the scene's first lane or of all of it. Throws
/// boost::program_options::error, and std::runtime_error for a camera that the scene does not have.
Camera ideal_camera(const RenderRequest& request, const Scene& scene);

}  // namespace cps
