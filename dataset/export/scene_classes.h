#pragma once

#include <nlohmann/json.hpp>

#include "dataset/export/source.h"

namespace cps {

/// What pixels of `semantic` mean, as dataset.json says: `conditions` lists the scene of each condition, and
/// `scenes` has the classes of each scene: `id`, then `name`, or `object` and `material` in a scene whose
/// classes have no names of their own, then `has_instances`. Throws std::runtime_error with one line when
/// dataset.json does not say it. Only where the source has frames.
nlohmann::ordered_json scene_classes(const ExportSource& source);

}  // namespace cps
