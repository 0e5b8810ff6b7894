#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

#include "apps/options.h"
#include "apps/progress.h"
#include "apps/render/error_curve.h"
#include "apps/render/lens.h"
#include "apps/render/output_file.h"
#include "apps/render/replay.h"
#include "apps/render/view.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "files/files.h"
#include "files/png.h"
#include "renderer/aov.h"
#include "renderer/camera_mask.h"
#include "renderer/memory_estimate.h"
#include "scenes/diffuse_materials.h"
#include "scenes/gltf_import.h"
#include "sensor/develop.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// A scene ready for rendering, and what is needed of it when its triangles are freed.
struct LoadedScene {
  Camera ideal;
  std::vector<std::string> material_names;
  std::shared_ptr<const RenderScene> ready;
  std::unique_ptr<LightCache> cache;  ///< null: all light is traced
};

constexpr double gib = 1 << 30;

std::size_t bytes_allowed(const RenderRequest& request) {
  return static_cast<std::size_t>(std::min(request.memory_gib, 1e6) * gib);
}

void require_memory(const RenderRequest& request, const Scene& scene) {
  const double needed_gib = static_cast<double>(estimated_bytes(scene)) / gib;
  if (request.memory_gib > 0 && needed_gib > request.memory_gib)
    throw std::runtime_error(
        fmt::format("{}: needs about {:.2f} GiB, --memory allows {:g}: allow more, or thin it out",
                    request.scene.string(), needed_gib, request.memory_gib));
}

LoadedScene load(const RenderRequest& request) {
  Scene scene = request.memory_gib > 0 ? import_gltf(request.scene, bytes_allowed(request))
                                       : import_gltf(request.scene);
  for (const std::string& warning : scene.import_warnings)
    fmt::print(stderr, "{}: warning: {}\n", request.scene.string(), warning);
  if (request.materials == "diffuse") make_diffuse(scene);
  require_memory(request, scene);
  LoadedScene loaded{ideal_camera(request, scene), {}, build_render_scene(scene, request.light.daylight), {}};
  if (request.light_method == LightMethod::cached)
    loaded.cache =
        std::make_unique<LightCache>(scene, *loaded.ready, request.render.max_shaded_vertices, request.cache);
  for (const Material& material : scene.materials) loaded.material_names.push_back(material.name);
  return loaded;
}

/// Layers that --aov asks for. Variance comes from rendering the picture itself.
struct WantedLayers {
  std::vector<Aov> aovs;
  bool variance = false;
};

WantedLayers wanted_layers(const RenderRequest& request) {
  WantedLayers wanted;
  if (!request.aov) return wanted;
  std::vector<std::string> names = aov_names();
  const bool can_vary = !request.lens || request.lens_in_camera;
  if (can_vary) names.emplace_back("variance");
  if (*request.aov != "all") names = flag_value<std::vector<std::string>>("aov", *request.aov);
  for (const std::string& name : names) try {
      if (name == "variance")
        wanted.variance = true;
      else
        wanted.aovs.push_back(aov_from_string(name));
    } catch (const std::runtime_error& error) {
      throw po::error(std::string("--") + error.what() + ", variance");
    }
  if (wanted.variance && !can_vary) throw po::error("--aov variance: with a lens, needs --lens-in-camera");
  return wanted;
}

/// Writes the picture. Returns the exposure of a PNG in stops.
std::optional<double> write_picture(const RenderRequest& request, OIIO::ImageBuf picture,
                                    std::vector<ImageLayer> layers) {
  if (request.output.extension() == ".exr") {
    layers.insert(layers.begin(), {"", std::move(picture)});
    write_exr(request.output, layers);
    return std::nullopt;
  }
  const double exposure = request.exposure_ev ? std::exp2(*request.exposure_ev) : meter_exposure(picture);
  write_png(request.output, picture, exposure, request.render.seed);
  return std::log2(exposure);
}

/// Shows a progress line if stderr is a terminal.
void show_progress(RenderOptions& options) {
  if (!isatty(STDERR_FILENO)) return;
  const auto progress = std::make_shared<std::optional<Progress>>();
  options.progress = [progress](int done, int total) {
    if (done == 1) progress->emplace("tiles", 0, total);
    (*progress)->advance(1, "");
    if (done == total) (*progress)->finish();
  };
}

}  // namespace

const Manual render_manual{
    .name = "cps render",
    .summary = "render one view of a glTF scene",
    .synopsis = {"SCENE -o FILE [--hfov DEG] [--size WxH] [--lens CALIBRATION] [--aov LIST]",
                 "SCENE --replay X,Y,S", "SCENE --reference FILE.exr"},
    .description = R"(
Renders one view of a glTF scene by path tracing, through a lens if one is
given. A .png is exposed and developed as by a camera; an .exr is linear and may
have further layers, such as depth and normals.

Instead, --replay prints what happens along a single light path, and --reference
prints the error against another render while the picture refines.
)",
    .examples = {{"cps render city.glb -o view.png --hfov 90 --size 960x540", "renders from the first lane"},
                 {"cps render city.glb -o view.exr --lens k1=-0.2,k2=0.03 --aov depth,normal,instance",
                  "renders through a lens, with three layers"},
                 {"cps render city.glb -o view.png --lens kannala_brandt:k1=-0.02 --hfov 190 --size 800x800 "
                  "--valid mask.png",
                  "renders through a fisheye, with a mask of what it sees"}},
    .see_also = {"cps city", "cps generate"},
};

int cps_render(const Arguments& arguments) {
  RenderRequest request;
  po::positional_options_description positional;
  positional.add("scene", 1);
  po::variables_map values;
  if (!parse_options(arguments, render_manual, describe(request), positional, values)) return 0;
  po::notify(values);
  finish(request);
  const WantedLayers wanted = wanted_layers(request);
  const ThreadLimit threads(values);

  const LoadedScene scene = load(request);
  request.render.cache = scene.cache.get();
  const LensView view = lens_view(request, scene.ideal);
  if (request.replay) {
    replay(*scene.ready, view.seen, request.render, *request.replay, scene.material_names, std::cout);
    return 0;
  }
  if (!request.valid.empty()) write_file(request.valid, encode_png(seen_pixels(view.seen)));
  show_progress(request.render);
  RenderSummary summary;
  OIIO::ImageBuf variance;
  OIIO::ImageBuf picture =
      request.reference
          ? render_against(*scene.ready, view.seen, request.render, *request.reference, std::cout, &summary)
          : render_through(*scene.ready, view, request, &summary, wanted.variance ? &variance : nullptr);
  if (request.output.empty()) return 0;
  std::vector<ImageLayer> layers = render_aovs(*scene.ready, view.seen, request.render, wanted.aovs);
  if (wanted.variance) layers.push_back({"variance", std::move(variance)});
  const std::optional<double> ev = write_picture(request, std::move(picture), std::move(layers));
  std::cout << request.output.string() << ": " << summary.brief();
  if (view.shown_hfov_deg) std::cout << ", H-FOV " << *view.shown_hfov_deg << " deg";
  if (ev) std::cout << ", exposure " << std::round(*ev * 100) / 100 << " EV";
  std::cout << "\n";
  return 0;
}

}  // namespace cps
