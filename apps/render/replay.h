#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "renderer/render.h"

namespace cps {

/// Traces one sample of one pixel again ("X,Y,S") and prints its path: every vertex with its place, material
/// and what it gave to the pixel. Throws boost::program_options::error where there is no such sample.
void replay(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
            const std::string& which, const std::vector<std::string>& material_names, std::ostream& out);

}  // namespace cps
