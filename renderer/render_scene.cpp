#include "renderer/render_scene.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace cps {

namespace {

/// How bright white unlit materials are: like white paper that lies on level ground.
float unlit_white(const SkyAndSun& light) {
  const Color sunlight = light.sun.radiance / light.sun.pdf * std::max(0.0f, light.sun.direction.y());
  return luminance(horizontal_irradiance(light.sky) + sunlight) * std::numbers::inv_pi_v<float>;
}

}  // namespace

RenderScene::RenderScene(const Scene& scene, SkyAndSun light)
    : materials(make_materials(scene, unlit_white(light))),
      placed(place_geometry(scene, materials)),
      bvh(placed),
      lamps(make_lamps(scene, placed)),
      sky(std::move(light.sky)),
      sun(light.sun) {}

std::shared_ptr<const RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight) {
  std::string why;
  if (!daylight.is_valid(&why)) throw std::runtime_error(why);
  return std::make_shared<const RenderScene>(scene, make_sky_and_sun(daylight));
}

}  // namespace cps
