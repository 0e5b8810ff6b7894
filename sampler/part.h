#pragma once

#include <string>

namespace cps {

/// The split that an image or a group belongs to. `all` applies only to lens0000, the undistorted group,
/// whose images belong to all three.
enum class Part { train, val, test, all };

std::string to_string(Part part);
/// Reads what to_string() writes. Throws std::runtime_error on any other word.
Part part_from_string(const std::string& word);

}  // namespace cps
