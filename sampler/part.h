#pragma once

#include <string>

namespace cps {

/// Which of the three splits an image or a group belongs to. `all` is only said of lens0000, the undistorted
/// group, whose images belong to different parts.
enum class Part { train, val, test, all };

std::string to_string(Part part);
/// Throws std::runtime_error on any other word.
Part part_from_string(const std::string& word);

}  // namespace cps
