#include "production/view_render.h"

namespace cps {

Camera camera_of(const PlannedView& view, const Pinhole& pinhole) {
  return {.world_from_camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera),
          .pinhole = pinhole};
}

RenderedHalves render_halves(const Recipe& recipe, const PlannedView& view, const Pinhole& pinhole,
                             LitScene& lit, const TileProgress& progress) {
  put_car(*lit.scene, world_from_vehicle(view.place));
  if (lit.cache) lit.cache->make_room();
  const double cells_before_s = lit.cache ? lit.cache->summary().cpu_s : 0;
  RenderedHalves halves;
  const auto render_half = [&](const char* stream) {
    RenderSummary summary;
    OIIO::ImageBuf half = render(*lit.scene, camera_of(view, pinhole),
                                 {.samples = recipe.samples / 2,
                                  .max_shaded_vertices = recipe.max_shaded_vertices,
                                  .seed = make_stream(view.seed, stream).key,
                                  .cache = lit.cache.get(),
                                  .progress = progress},
                                 &summary);
    halves.cpu_s += summary.cpu_s;
    return half;
  };
  halves.first = render_half("first half");
  halves.second = render_half("second half");
  if (lit.cache) halves.cells_cpu_s = lit.cache->summary().cpu_s - cells_before_s;
  return halves;
}

}  // namespace cps
