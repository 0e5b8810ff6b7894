#pragma once

#include <Eigen/Geometry>

#include "apps/render/request.h"
#include "scenes/scene.h"

namespace cps {

/// The camera without a lens: size, field of view and pose from the options, else from the glTF camera that
/// they name, else a view along the scene's first lane, else of the whole scene. Throws
/// boost::program_options::error, and std::runtime_error for a camera that the scene does not have.
Camera ideal_camera(const RenderRequest& request, const Scene& scene);

}  // namespace cps
