#pragma once

#include "scenes/classes/semantic_classes.h"

namespace cps {

/// Whether the scene's file is as `cps city` wrote it. A program that changes such a file names itself as the
/// generator, and may change the names that the classes are told from.
bool is_procedural_city(const Scene& scene);

/// All classes of Cityscapes, and those of a procedural city's instances, told from the names of object and
/// material. Names that no city has get class 0, unlabeled. The background is the sky.
SceneClasses city_classes(const Scene& scene);

}  // namespace cps
