#include "renderer/render_scene.h"

#include <stdexcept>

namespace cps {

RenderScene::RenderScene(const Scene& scene, SkyAndSun light)
    : materials(make_materials(scene)),
      placed(place_geometry(scene, materials)),
      bvh(placed),
      sky(std::move(light.sky)),
      sun(light.sun) {}

std::shared_ptr<const RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight) {
  std::string why;
  if (!daylight.is_valid(&why)) throw std::runtime_error(why);
  return std::make_shared<const RenderScene>(scene, make_clear_day(daylight));
}

}  // namespace cps
