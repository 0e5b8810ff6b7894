#include "apps/render/request.h"

#include <cmath>

#include "apps/options.h"
#include "apps/threads.h"

namespace po = boost::program_options;

namespace cps {
namespace {

template <class T>
po::typed_value<T>* optional(std::optional<T>& target) {
  return po::value<T>()->notifier([&target](const T& value) { target = value; });
}

po::typed_value<std::string>* optional(std::optional<std::filesystem::path>& target) {
  return po::value<std::string>()->notifier([&target](const std::string& value) { target = value; });
}

template <class T>
po::typed_value<T>* with_default(T& target) {
  return po::value(&target)->default_value(target);
}

LightMethod parsed_light_method(const std::string& word) try {
  return light_method_from(word);
} catch (const std::runtime_error& error) {
  throw po::error("--light " + word + ": " + error.what());
}

void describe_camera(RenderRequest& request, po::options_description_easy_init add) {
  add("size", optional(request.size)->value_name("WxH"),
      "WIDTHxHEIGHT, pixels [the --lens file's, or 1392x512]");
  add("camera", optional(request.camera)->value_name("NAME"),
      "take pose and field of view of a glTF camera: its name or number");
  add("hfov", optional(request.hfov_deg),
      "horizontal field of view, degrees; with k1=.. as --lens, before the crop; with FAMILY:.., what the "
      "picture shows, which may be 180 and more [the --camera's, or 70]");
  add("position", optional(request.position)->value_name("X,Y,Z"),
      "X,Y,Z of the camera, metres, y up [the first lane, or a view of the whole scene]");
  add("look-at", optional(request.look_at)->value_name("X,Y,Z"),
      "X,Y,Z of the point in the middle of the picture, metres");
  add("lens", optional(request.lens)->value_name("LENS"),
      "a calibration file, or coefficients k1=..,k2=..,k3=..,p1=..,p2=..: renders an undistorted master and "
      "warps it, as for a dataset. FAMILY:name=value,.. is a lens of another family: rational, "
      "kannala_brandt, unified_spherical, eucm or double_sphere");
  add("lens-camera", optional(request.lens_camera)->value_name("NAME"),
      "name of the camera in a --lens file with several");
  add("lens-in-camera", po::bool_switch(&request.lens_in_camera),
      "trace each ray through the lens instead of warping a master: exact, but slower to converge; families "
      "other than brown_conrady are always traced so");
}

void describe_sampling(RenderRequest& request, po::options_description_easy_init add) {
  RenderOptions& render = request.render;
  add("samples", with_default(render.samples), "light paths traced per pixel; more: less noise");
  add("max_shaded_vertices", with_default(render.max_shaded_vertices),
      "surface points at which a path gathers light");
  add("light",
      po::value<std::string>()
          ->value_name("WORD")
          ->default_value(to_string(request.light_method))
          ->notifier(
              [&request](const std::string& word) { request.light_method = parsed_light_method(word); }),
      "traced: follow all light; cached: keep the light of the sky and between surfaces in cells of the scene, "
      "which has little noise and costs less");
  add("cache_memory", with_default(request.cache.memory_gib),
      "GiB for the cells of --light cached; what does not fit is computed again");
  add("filter", with_default(request.filter)->value_name("WORD"),
      "how a pixel weighs the light around it: box, tent or gaussian");
  add("materials", with_default(request.materials)->value_name("WORD"),
      "all, or diffuse: base colours only, to compare with other renderers");
  add("seed", with_default(render.seed), "seed of the random choice of paths");
  add("memory", with_default(request.memory_gib),
      "GiB; a scene that needs more is refused before it is built; 0: no limit");
}

void describe_output(RenderRequest& request, po::options_description_easy_init add) {
  add("out,o", path_value(request.output), "file to write: .png (8-bit sRGB) or .exr (linear, kcd/m2)");
  add("exposure", optional(request.exposure_ev),
      "exposure of a .png, stops: its value is radiance (kcd/m2) times 2^EV [metered on the picture]");
  add("aov", optional(request.aov)->value_name("LIST"),
      "add layers to the .exr: all, or a list of depth,distance,normal,albedo,position,instance,material,"
      "variance");
  add("valid", path_value(request.valid),
      "also write which pixels the lens shows, as a .png: 255, or 0 where a fisheye sees nothing");
  add("replay", optional(request.replay)->value_name("X,Y,S"),
      "X,Y,S: print the path of sample S of pixel X,Y vertex by vertex instead of rendering");
  add("reference", optional(request.reference)->value_name("FILE"),
      "an .exr of the same view: print the error against it as CSV while the picture refines");
}

PixelFilter filter_from_string(const std::string& name) {
  if (name == "box") return PixelFilter::box;
  if (name == "tent") return PixelFilter::tent;
  if (name == "gaussian") return PixelFilter::gaussian;
  throw po::error("--filter " + name + ": must be box, tent or gaussian");
}

void check_output(const RenderRequest& request) {
  if (request.output.empty()) {
    if (request.replay || request.reference) return;
    throw po::error("--out: is missing; name a .png or .exr");
  }
  const std::string kind = request.output.extension().string();
  if (kind != ".png" && kind != ".exr")
    throw po::error("--out " + request.output.string() + ": must end in .png or .exr");
  if (request.aov && kind != ".exr") throw po::error("--aov: needs an .exr as --out");
  if (request.valid == request.output) throw po::error("--valid: names the same file as --out; name another");
}

void read_lens(RenderRequest& request) {
  if (!request.lens) return;
  request.lens_choice = lens_choice(*request.lens, request.lens_camera.value_or(""));
  // No flat master holds what a fisheye sees.
  if (!request.lens_choice->is_brown_conrady()) request.lens_in_camera = true;
}

void check_hfov(const RenderRequest& request) {
  if (!request.hfov_deg) return;
  const bool is_ideal = !request.lens_choice || request.lens_choice->is_brown_conrady();
  const double limit_deg = is_ideal ? 180 : 360;
  if (!(*request.hfov_deg > 0 && *request.hfov_deg < limit_deg))
    throw po::error("--hfov: must lie between 0 and " + std::to_string(static_cast<int>(limit_deg)) +
                    " degrees");
}

void check_lens(const RenderRequest& request) {
  if (!request.lens && (request.lens_in_camera || request.lens_camera))
    throw po::error("--lens-in-camera, --lens-camera: need --lens");
  if (!request.lens && !request.valid.empty()) throw po::error("--valid: needs --lens");
  const bool by_warp = request.lens && !request.lens_in_camera;
  if (by_warp && (request.replay || request.reference))
    throw po::error("--replay, --reference: a lens needs --lens-in-camera");
  if (by_warp && request.filter != "box")
    throw po::error("--filter: the warp has its own; with --lens-in-camera any will do");
}

}  // namespace

po::options_description describe(RenderRequest& request) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("scene", path_value(request.scene)->required(), "the scene: a .glb or .gltf file");
  describe_output(request, add);
  describe_camera(request, add);
  describe_light(request.light, add);
  describe_sampling(request, add);
  add_threads_option(options);
  return options;
}

void finish(RenderRequest& request) {
  request.render.filter = filter_from_string(request.filter);
  if (const std::string fault = request.render.fault(); !fault.empty()) throw po::error("--" + fault);
  request.light.daylight = daylight_of(request.light);
  if (!(request.memory_gib >= 0)) throw po::error("--memory: must be 0 or more");
  if (request.exposure_ev && !(std::abs(*request.exposure_ev) <= 64))
    throw po::error("--exposure: must lie in [-64, 64]");
  if (const std::string fault = request.cache.fault(); !fault.empty()) throw po::error("--" + fault);
  if (request.materials != "all" && request.materials != "diffuse")
    throw po::error("--materials " + request.materials + ": must be all or diffuse");
  check_output(request);
  read_lens(request);
  check_hfov(request);
  check_lens(request);
}

}  // namespace cps
