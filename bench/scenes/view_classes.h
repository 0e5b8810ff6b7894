#pragma once

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace cps {

/// The class of what a pixel shows, from its material's name in a procedural city.
enum class ViewClass { sky, road, other_ground, building, vegetation, vehicle, other };
constexpr int view_class_count = 7;

std::string to_string(ViewClass view_class);

/// The class of each material id of the material AOV: 0 is the sky, then the scene's materials in order.
std::vector<ViewClass> classes_of_materials(const Scene& city);

}  // namespace cps
