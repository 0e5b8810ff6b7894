#include "apps/render/request.h"

#include <cmath>

#include "apps/threads.h"

namespace po = boost::program_options;

namespace cps {
namespace {

template <class T>
po::typed_value<T>* optional(std::optional<T>& target) {
  return po::value<T>()->notifier([&target](const T& value) { target = value; });
}

template <class T>
po::typed_value<T>* with_default(T& target) {
  return po::value(&target)->default_value(target);
}

void describe_camera(RenderRequest& request, po::options_description_easy_init add) {
  add("size", optional(request.size), "WIDTHxHEIGHT, pixels [the lens file's, or 1392x512]");
  add("camera", optional(request.camera), "a glTF camera, by name or number from 0");
  add("hfov", optional(request.hfov_deg),
      "horizontal field of view, degrees; with coefficients as --lens, before the crop [the camera's, or "
      "70]");
  add("position", optional(request.position),
      "X,Y,Z of the camera, metres, y up [the first lane, or a view of it all]");
  add("look-at", optional(request.look_at), "X,Y,Z of the point in the middle of the picture");
  add("lens", optional(request.lens),
      "a calibration file, or k1=..,k2=..,k3=..,p1=..,p2=..: a master is rendered and warped as for a "
      "dataset");
  add("lens-camera", optional(request.lens_camera), "which camera of the --lens file");
  add("lens-in-camera", po::bool_switch(&request.lens_in_camera),
      "trace each ray through the lens instead: slower to converge, exact");
}

void describe_sampling(RenderRequest& request, po::options_description_easy_init add) {
  RenderOptions& render = request.render;
  add("samples", with_default(render.samples), "paths per pixel");
  add("bounces", with_default(render.max_shaded_vertices), "surfaces that a path may meet");
  add("filter", with_default(request.filter), "of the pixels: box, tent or gaussian");
  add("materials", with_default(request.materials), "all, or diffuse: base colours only, for comparisons");
  add("seed", with_default(render.seed), "of the sampling");
  add("memory", with_default(request.memory_gib), "GiB; a scene that needs more is refused; 0: no limit");
}

void describe_output(RenderRequest& request, po::options_description_easy_init add) {
  add("output,o", po::value(&request.output), "a .png (8-bit sRGB) or .exr (linear, kcd/m2)");
  add("exposure", optional(request.exposure_ev),
      "stops: a .png's value is radiance (kcd/m2) times 2^EV [metered]");
  add("aov", optional(request.aov),
      "more layers of the .exr: all, or a list of depth,distance,normal,albedo,position,instance,material,"
      "variance");
  add("replay", optional(request.replay), "X,Y,S: no picture, but sample S of pixel X,Y, vertex by vertex");
  add("reference", optional(request.reference),
      "an .exr: print the error against it as CSV while the picture refines");
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
    throw po::error("--output: is missing: name a .png or .exr");
  }
  const std::string kind = request.output.extension().string();
  if (kind != ".png" && kind != ".exr")
    throw po::error("--output " + request.output.string() + ": must end in .png or .exr");
  if (request.aov && kind != ".exr") throw po::error("--aov: needs an .exr as --output");
}

void check_lens(const RenderRequest& request) {
  if (!request.lens && (request.lens_in_camera || request.lens_camera))
    throw po::error("--lens-in-camera, --lens-camera: need --lens");
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
  add("scene", po::value(&request.scene)->required(), "a .glb or .gltf file");
  describe_output(request, add);
  describe_camera(request, add);
  describe_light(request.light, add);
  describe_sampling(request, add);
  add_threads_option(options);
  return options;
}

void finish(RenderRequest& request) {
  request.render.filter = filter_from_string(request.filter);
  std::string why;
  if (!request.render.is_valid(&why)) throw po::error(why);
  request.light.daylight = daylight_of(request.light);
  if (request.hfov_deg && !(*request.hfov_deg > 0 && *request.hfov_deg < 180))
    throw po::error("--hfov: must lie between 0 and 180 degrees");
  if (!(request.memory_gib >= 0)) throw po::error("--memory: must be 0 or more");
  if (request.exposure_ev && !(std::abs(*request.exposure_ev) <= 64))
    throw po::error("--exposure: must lie in [-64, 64]");
  if (request.materials != "all" && request.materials != "diffuse")
    throw po::error("--materials " + request.materials + ": must be all or diffuse");
  check_output(request);
  check_lens(request);
}

}  // namespace cps
