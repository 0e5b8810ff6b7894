#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "apps/render/lens_choice.h"
#include "apps/render/light_options.h"
#include "renderer/cache/light_cache.h"
#include "renderer/render.h"
#include "sampler/recipe/light_method.h"

namespace cps {

/// Options of `cps render`, as the user wrote them.
struct RenderRequest {
  std::filesystem::path scene, output;
  std::optional<std::string> size, camera, position, look_at;
  std::optional<double> hfov_deg;
  std::optional<std::string> lens, lens_camera;
  std::optional<LensChoice> lens_choice;  ///< what `lens` names; set by finish()
  bool lens_in_camera = false;            ///< set by finish() where the lens leaves no choice
  std::filesystem::path valid;            ///< mask to write; may be empty
  std::optional<std::string> aov, replay;
  std::optional<std::filesystem::path> reference;
  std::optional<double> exposure_ev;
  std::string filter = "box", materials = "all";
  LightMethod light_method = LightMethod::traced;
  LightCacheOptions cache;
  double memory_gib = 0;  ///< 0: no limit
  RenderOptions render;
  LightRequest light;
};

/// Every option with its help text, bound to `request`.
boost::program_options::options_description describe(RenderRequest& request);

/// Parses the options that are texts and checks all; reads the --lens file. Throws
/// boost::program_options::error, and std::runtime_error for a --lens file that cannot be read.
void finish(RenderRequest& request);

}  // namespace cps
