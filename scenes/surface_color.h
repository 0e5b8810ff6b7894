#pragma once

#include "scenes/scene.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The mean of a texture's texels, linear; of a large one, of every so-manieth texel.
Eigen::Vector3f mean_color(const Texture& texture);

/// A material's base colour (linear), and the light that it emits (kcd/m²; an unlit one shows its base
/// colour), each with the mean of its texture.
Eigen::Vector3f mean_base_color(const Scene& scene, const Material& material);
Eigen::Vector3f mean_emission(const Scene& scene, const Material& material);

/// The base colour (linear) at a point of a surface: of the nearest texel and vertex colours.
Eigen::Vector3f base_color_at(const Scene& scene, const SurfaceHit& hit);

}  // namespace cps
