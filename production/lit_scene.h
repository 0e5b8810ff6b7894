#pragma once

#include <memory>

#include "renderer/cache/light_cache.h"

namespace cps {

/// A condition's scene, ready to render.
struct LitScene {
  std::shared_ptr<RenderScene> scene;
  std::unique_ptr<LightCache> cache;  ///< of this scene; null: all light is traced
};

}  // namespace cps
