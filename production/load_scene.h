#pragma once

#include <filesystem>

#include "production/watch.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// Loads a scene for a plan. Notes how cars drive through it, warns of what the importer left out, and shows
/// it to the watch. Throws Interrupted when the watch stops it, and as load_driven_scene() does.
DrivenScene load_scene(const std::filesystem::path& file, const DriveOptions& options, const Watch& watch);

}  // namespace cps
