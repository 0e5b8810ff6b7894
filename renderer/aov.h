#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>
#include <vector>

#include "renderer/render.h"

namespace cps {

/// Layers that a picture can have beside its radiance ("arbitrary output variables"). All but albedo hold the
/// hit of the pixel's central ray, through the lens, and are never averaged.
enum class Aov {
  depth,     ///< Z: metres along the optical axis, negative behind a fisheye; infinite where nothing was hit
  distance,  ///< Y: metres along the ray; infinite where nothing was hit
  normal,    ///< X, Y, Z: unit vector in the world, with normal maps, towards the camera
  albedo,    ///< R, G, B: glTF's base colour, averaged over the pixel
  position,  ///< X, Y, Z: metres in the world
  instance,  ///< id: 1 + index in Scene::instances; 0: nothing was hit. 32-bit unsigned, exact
  material,  ///< id: 1 + index in Scene::materials; 0: nothing was hit. 32-bit unsigned, exact
};

/// Names of all layers, in the enum's order.
const std::vector<std::string>& aov_names();

/// The layer of this name. Throws std::runtime_error that lists the known names.
Aov aov_from_string(const std::string& name);

/// One layer of a picture. Its channels are called `name`.X, …
struct ImageLayer {
  std::string name;
  OIIO::ImageBuf image;
};

/// The wanted layers, in this order, float or uint32, at the camera's size. Throws as render() does.
std::vector<ImageLayer> render_aovs(const RenderScene& scene, const Camera& camera,
                                    const RenderOptions& options, const std::vector<Aov>& wanted);

}  // namespace cps
