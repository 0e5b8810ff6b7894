#pragma once

#include <filesystem>

#include "production/watch.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// Loads a scene for a plan. Notes how cars drive through it, warns of what the importer left out, and shows
/// it to the watch. Throws Interrupted when the watch stops it, and as load_driven_scene() does.
DrivenScene load_scene(const std::filesystem::path& file, const DriveOptions& options, const Watch& watch);

/// For Watch::scene_loaded: writes `folder`/NAME.png, a picture from above of each scene and its lanes
/// (top_view.h). NAME is that of the scene's file. Throws std::runtime_error in one line when a picture
/// cannot be written.
std::function<void(const std::filesystem::path&, const DrivenScene&)> top_views_in(
    const std::filesystem::path& folder);

}  // namespace cps
