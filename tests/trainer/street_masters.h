#pragma once

#include <filesystem>

#include "distortion/image_size.h"

namespace cps {

/// Adds to a dataset what online lenses need: `count` kept masters of train streets, seen by undistorted
/// cameras of `size` whose H-FOVs spread over 40…100°, and the recipe. The same street as render_street()'s.
void keep_street_masters(const std::filesystem::path& root, const ImageSize& size, int count);

}  // namespace cps
