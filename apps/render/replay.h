#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "renderer/render.h"

namespace cps {

/// Traces one sample of one pixel ("X,Y,S") again and prints its path: position, material and contribution to
/// the pixel of every vertex. Throws boost::program_options::error if there is no such sample.
void replay(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
            const std::string& which, const std::vector<std::string>& material_names, std::ostream& out);

}  // namespace cps
