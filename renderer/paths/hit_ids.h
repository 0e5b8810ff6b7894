#pragma once

#include "renderer/paths/render_scene.h"

namespace cps {

/// Instance and material of a hit: indices into Scene::instances and Scene::materials.
struct HitIds {
  std::uint32_t instance, material;
};

inline HitIds ids_of(const RenderScene& scene, const Hit& hit) {
  const Placement& placement = scene.placed.placements[hit.placement];
  const auto material =
      scene.placed.geometries[placement.geometry].material - scene.materials.surfaces.data();
  return {static_cast<std::uint32_t>(placement.instance), static_cast<std::uint32_t>(material)};
}

}  // namespace cps
