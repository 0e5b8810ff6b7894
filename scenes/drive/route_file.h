#pragma once

#include <filesystem>
#include <vector>

#include "scenes/scene.h"

namespace cps {

/// A drive as a CSV file: a point a line, `x,y,z` in the scene's units (y up), or `x,y,z,heading_deg` (about
/// +y, 0 along +x, growing to the left); the first line may name these columns. Without headings it is a lane
/// through the points; with them every point is a place of its own. It is cut into stretches of about 60 m,
/// streets of their own, so that it can be dealt to train, val and test. `metres_per_unit` scales the points.
/// Throws std::runtime_error in one line: file, line, fix.
std::vector<Lane> read_route(const std::filesystem::path& file, double metres_per_unit);

}  // namespace cps
