#pragma once

#include "scenes/scene.h"

namespace cps {

/// Checks indices, sizes and numbers of a scene's materials and textures. Throws std::runtime_error in one
/// line that names the material or texture and the fault.
void check_materials(const Scene& scene);

}  // namespace cps
