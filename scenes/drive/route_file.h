#pragma once

#include <filesystem>
#include <vector>

#include "scenes/drive/file_frame.h"
#include "scenes/scene.h"

namespace cps {

/// Reads a route from a CSV file with one point per line: `x,y,z` in the units and axes of the scene's file,
/// or `x,y,z,heading_deg` (about the axis that points up, 0 along +x, anticlockwise seen from above). The
/// first line may name these columns. Without headings the route is a lane through the points; with headings
/// every point is a place of its own. The route is cut into stretches of about 60 m, each a street of its
/// own, so that it can be split into train, val and test. Throws std::runtime_error with one line: file,
/// line, fix.
std::vector<Lane> read_route(const std::filesystem::path& file, const FileFrame& frame);

}  // namespace cps
