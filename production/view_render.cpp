#include "production/view_render.h"

namespace cps {
namespace {

/// Renders pictures of one view, with its car in its place.
class ViewRenderer {
 public:
  ViewRenderer(const Recipe& recipe, const PlannedView& view, LitScene& lit, const TileProgress& progress)
      : recipe_(recipe), lit_(lit), progress_(progress) {
    put_car(*lit.scene, world_from_vehicle(view.place));
    if (lit.cache) lit.cache->make_room();
    cells_before_s_ = all_cells_cpu_s();
  }

  /// `options`: samples, seed and filter. Adds the CPU seconds.
  OIIO::ImageBuf render(const Camera& camera, RenderOptions options, double& cpu_s) const {
    options.max_shaded_vertices = recipe_.max_shaded_vertices;
    options.cache = lit_.cache.get();
    options.progress = progress_;
    RenderSummary summary;
    OIIO::ImageBuf image = cps::render(*lit_.scene, camera, options, &summary);
    cpu_s += summary.cpu_s;
    return image;
  }

  /// CPU seconds for the light cache's cells so far.
  double cells_cpu_s() const { return all_cells_cpu_s() - cells_before_s_; }

 private:
  double all_cells_cpu_s() const { return lit_.cache ? lit_.cache->summary().cpu_s : 0; }

  const Recipe& recipe_;
  LitScene& lit_;
  const TileProgress& progress_;
  double cells_before_s_ = 0;
};

}  // namespace

Camera camera_of(const PlannedView& view, const Pinhole& pinhole) {
  return {.world_from_camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera),
          .pinhole = pinhole};
}

RenderedView render_halves(const Recipe& recipe, const PlannedView& view, const Pinhole& pinhole,
                           LitScene& lit, const TileProgress& progress) {
  const ViewRenderer renderer(recipe, view, lit, progress);
  const Camera camera = camera_of(view, pinhole);
  RenderedView rendered;
  const auto render_half = [&](const char* stream) {
    return renderer.render(
        camera, {.samples = recipe.samples / 2, .seed = make_stream(view.seed, stream).key}, rendered.cpu_s);
  };
  rendered.first = render_half("first half");
  rendered.second = render_half("second half");
  rendered.cells_cpu_s = renderer.cells_cpu_s();
  return rendered;
}

RenderedView trace_images(const Recipe& recipe, const PlannedView& view, std::span<const ModelCamera> cameras,
                          LitScene& lit, const TileProgress& progress) {
  const ViewRenderer renderer(recipe, view, lit, progress);
  RenderedView rendered;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Camera camera = camera_of(view, cameras[i].pinhole);
    camera.lens = cameras[i].lens;
    rendered.traced.push_back(
        renderer.render(camera,
                        {.samples = 4 * recipe.samples,
                         .seed = substream(make_stream(view.seed, "traced image"), i).key,
                         .filter = PixelFilter::gaussian},
                        rendered.cpu_s));
  }
  rendered.cells_cpu_s = renderer.cells_cpu_s();
  return rendered;
}

}  // namespace cps
