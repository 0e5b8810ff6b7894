#include "renderer/render.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/verbs.h"
#include "dataset/files.h"
#include "dataset/png.h"
#include "scenes/gltf_import.h"
#include "sensor/develop.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

constexpr double eye_height_m = 1.65;

/// "X,Y,Z".
Eigen::Vector3d parse_point(const std::string& option, const std::string& text) {
  std::istringstream in(text);
  Eigen::Vector3d point;
  char comma1 = 0, comma2 = 0;
  if (in >> point.x() >> comma1 >> point.y() >> comma2 >> point.z() && comma1 == ',' && comma2 == ',' &&
      in.peek() == EOF && point.allFinite()) {
    return point;
  }
  throw po::error("--" + option + " " + text + ": must be X,Y,Z in metres");
}

/// "WxH".
Eigen::Vector2i parse_size(const std::string& text) {
  std::istringstream in(text);
  Eigen::Vector2i size;
  char x = 0;
  if (in >> size.x() >> x >> size.y() && x == 'x' && in.peek() == EOF && size.minCoeff() >= 1 &&
      size.maxCoeff() <= 32768) {
    return size;
  }
  throw po::error("--size " + text + ": must be WIDTHxHEIGHT in pixels, at most 32768 each");
}

Eigen::Isometry3d looking_at(const Eigen::Vector3d& from, const Eigen::Vector3d& at) {
  const Eigen::Vector3d forward = (at - from).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY());
  if (!forward.allFinite() || forward.norm() < 0.5)
    throw po::error("--look-at: must differ from the camera's position");
  if (right.norm() < 1e-6) right = Eigen::Vector3d::UnitX();  // straight up or down
  right.normalize();
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  world_from_camera.linear() << right, forward.cross(right), forward;
  world_from_camera.translation() = from;
  return world_from_camera;
}

struct View {
  Eigen::Vector3d position, look_at;
};

/// From the beginning of the first lane along it; without lanes, down on the whole scene from a corner.
View default_view(const Scene& scene, const Pinhole& pinhole) {
  for (const Lane& lane : scene.lanes) {
    if (lane.points.size() < 2) continue;
    const Eigen::Vector3d up(0, eye_height_m, 0);
    return {lane.points[0].cast<double>() + up, lane.points[1].cast<double>() + up};
  }
  if (scene.bounds.isEmpty()) return {{0, 0, 3}, {0, 0, 0}};
  const Eigen::Vector3d center = scene.bounds.center().cast<double>();
  const double radius = std::max(0.5 * scene.bounds.diagonal().cast<double>().norm(), 1e-3);
  const double narrower = std::min(pinhole.width / pinhole.fx, pinhole.height / pinhole.fy);
  const double distance = radius / std::sin(std::atan(0.5 * narrower));
  return {center + distance * Eigen::Vector3d(0.6, 0.45, 0.75).normalized(), center};
}

std::string encode_exr(const OIIO::ImageBuf& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  OIIO::ImageSpec spec = image.spec();
  spec.attribute("compression", "zip");
  const auto out = OIIO::ImageOutput::create("picture.exr", &memory);
  if (!out || !out->open("picture.exr", spec) ||
      !out->write_image(OIIO::TypeDesc::FLOAT, image.localpixels()) || !out->close()) {
    throw std::runtime_error("EXR: " + (out ? out->geterror() : OIIO::geterror()));
  }
  return {bytes.begin(), bytes.end()};
}

struct RenderRequest {
  fs::path scene, output;
  std::string size = "1392x512", position, look_at;
  double hfov_deg = 70;
  std::optional<double> exposure_ev;
  int threads = 0;
  RenderOptions render;
  Daylight daylight;
};

po::options_description describe(RenderRequest& request) {
  RenderOptions& render = request.render;
  Daylight& day = request.daylight;
  po::options_description options("Options");
  auto add = options.add_options();
  add("scene", po::value(&request.scene)->required(), "a .glb or .gltf file");
  add("output,o", po::value(&request.output)->required(), "a .png (8-bit sRGB) or .exr (linear, kcd/m2)");
  add("size", po::value(&request.size)->default_value(request.size), "WIDTHxHEIGHT, pixels");
  add("hfov", po::value(&request.hfov_deg)->default_value(request.hfov_deg),
      "horizontal field of view, degrees");
  add("position", po::value(&request.position),
      "X,Y,Z of the camera, metres, y up [the first lane, or a view of it all]");
  add("look-at", po::value(&request.look_at), "X,Y,Z of the point in the middle of the picture");
  add("samples", po::value(&render.samples)->default_value(render.samples), "paths per pixel");
  add("bounces", po::value(&render.max_shaded_vertices)->default_value(render.max_shaded_vertices),
      "surfaces that a path may meet");
  add("exposure", po::value<double>()->notifier([&request](double ev) { request.exposure_ev = ev; }),
      "stops: a .png's value is radiance (kcd/m2) times 2^EV [metered]");
  add("sun-elevation", po::value(&day.sun_elevation_deg)->default_value(day.sun_elevation_deg),
      "degrees above the horizon");
  add("sun-azimuth", po::value(&day.sun_azimuth_deg)->default_value(day.sun_azimuth_deg),
      "degrees clockwise from north (-z)");
  add("turbidity", po::value(&day.turbidity)->default_value(day.turbidity),
      "of the air: 2 very clear, 3 clear, 6 hazy");
  add("seed", po::value(&render.seed)->default_value(render.seed), "of the sampling");
  add("threads", po::value(&request.threads)->default_value(request.threads), "0: all");
  return options;
}

void check(const RenderRequest& request) {
  std::string why;
  if (!request.render.is_valid(&why) || !request.daylight.is_valid(&why)) throw po::error(why);
  if (!(request.hfov_deg > 0 && request.hfov_deg < 180))
    throw po::error("--hfov: must lie between 0 and 180 degrees");
  if (request.threads < 0) throw po::error("--threads: must be 0 or more");
  if (request.exposure_ev && !(std::abs(*request.exposure_ev) <= 64))
    throw po::error("--exposure: must lie in [-64, 64]");
  const std::string kind = request.output.extension().string();
  if (kind != ".png" && kind != ".exr")
    throw po::error("--output " + request.output.string() + ": must end in .png or .exr");
}

Camera make_camera(const RenderRequest& request, const Scene& scene) {
  const Eigen::Vector2i size = parse_size(request.size);
  Camera camera;
  camera.pinhole = pinhole_from_hfov(size.x(), size.y(), radians(request.hfov_deg));
  View view = default_view(scene, camera.pinhole);
  const Eigen::Vector3d ahead = view.look_at - view.position;
  if (!request.position.empty()) {
    view.position = parse_point("position", request.position);
    view.look_at = view.position + ahead;
  }
  if (!request.look_at.empty()) view.look_at = parse_point("look-at", request.look_at);
  camera.world_from_camera = looking_at(view.position, view.look_at);
  return camera;
}

/// Writes the picture; returns the exposure in stops, if one was needed.
std::optional<double> write_picture(const RenderRequest& request, const OIIO::ImageBuf& linear) {
  if (request.output.extension() == ".exr") {
    write_file(request.output, encode_exr(linear));
    return std::nullopt;
  }
  const double exposure = request.exposure_ev ? std::exp2(*request.exposure_ev) : meter_exposure(linear);
  constexpr SensorSettings noiseless{.exposure_bias_ev = 0, .full_well_e = 1e15, .read_noise_e = 0};
  write_file(request.output,
             encode_png(develop(linear, exposure, noiseless, make_stream(request.render.seed, "sensor"))));
  return std::log2(exposure);
}

}  // namespace

int cps_render(const Arguments& arguments) {
  RenderRequest request;
  po::positional_options_description positional;
  positional.add("scene", 1);
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps render SCENE -o FILE\nOne view of a glTF scene by path tracing, under a clear sky.\n",
          describe(request), positional, values)) {
    return 0;
  }
  po::notify(values);
  check(request);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    request.threads > 0 ? request.threads : tbb::info::default_concurrency());

  const Scene scene = import_gltf(request.scene);
  const Camera camera = make_camera(request, scene);
  const auto render_scene = build_render_scene(scene, request.daylight);
  RenderSummary summary;
  const OIIO::ImageBuf image = render(*render_scene, camera, request.render, &summary);
  const std::optional<double> ev = write_picture(request, image);
  std::cout << request.output.string() << ": " << summary.brief();
  if (ev) std::cout << ", exposure " << std::round(*ev * 100) / 100 << " EV";
  std::cout << "\n";
  return 0;
}

}  // namespace cps
