#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/cache/light_cache.h"

namespace cps {

/// What instance and semantic labels say of a scene: pixel values, parallel to Scene::instances.
struct InstanceLabels {
  std::vector<std::uint16_t> object;      ///< 1 + index into Scene::objects
  std::vector<std::uint16_t> semantic;    ///< class
  std::uint16_t semantic_background = 0;  ///< class where a ray meets nothing
};

/// A condition's scene, ready to render.
struct LitScene {
  std::shared_ptr<RenderScene> scene;
  std::unique_ptr<LightCache> cache;  ///< of this scene; null: all light is traced
  InstanceLabels labels = {};         ///< of the dense labels that the recipe asks for
};

}  // namespace cps
