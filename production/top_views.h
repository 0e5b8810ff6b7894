#pragma once

#include <filesystem>
#include <functional>

#include "scenes/drive/driven_scene.h"

namespace cps {

/// For Watch::scene_loaded: writes `folder`/NAME.png, a picture from above of each scene and its lanes
/// (top_view.h). NAME is that of the scene's file. Throws std::runtime_error in one line when a picture
/// cannot be written.
std::function<void(const std::filesystem::path&, const DrivenScene&)> top_views_in(
    const std::filesystem::path& folder);

}  // namespace cps
