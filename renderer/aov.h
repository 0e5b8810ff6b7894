#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>
#include <vector>

#include "renderer/render.h"

namespace cps {

/// Pictures of what stands before the camera beside its light ("arbitrary output variables"). All but albedo
/// show the pixel's central ray, through the lens, and are never averaged.
enum class Aov {
  depth,     ///< Z: metres along the optical axis; infinite: nothing there
  distance,  ///< Y: metres along the ray; infinite: nothing there
  normal,    ///< X, Y, Z: of the surface in the world, bumps of normal maps included, towards the camera
  albedo,    ///< R, G, B: glTF's base colour, averaged over the pixel
  position,  ///< X, Y, Z: metres in the world
  instance,  ///< id: 1 + index in Scene::instances; 0: nothing there. 32-bit unsigned, exact
  material,  ///< id: 1 + index in Scene::materials; 0: nothing there. 32-bit unsigned, exact
};

/// Names of all of them, in order.
const std::vector<std::string>& aov_names();

/// Throws std::runtime_error listing the names there are.
Aov aov_from_string(const std::string& name);

/// One of a picture's layers: its channels are called `name`.X, …
struct ImageLayer {
  std::string name;
  OIIO::ImageBuf image;
};

/// The wanted ones, float or uint32, at the camera's size. Throws as render().
std::vector<ImageLayer> render_aovs(const RenderScene& scene, const Camera& camera,
                                    const RenderOptions& options, const std::vector<Aov>& wanted);

}  // namespace cps
