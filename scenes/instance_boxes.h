#pragma once

#include <vector>

#include "scenes/scene.h"

namespace cps {

/// The box (world) around each instance's transformed mesh box: a little too large for rotated instances,
/// never too small.
std::vector<Eigen::AlignedBox3f> instance_boxes(const Scene& scene);

}  // namespace cps
