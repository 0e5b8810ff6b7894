// Cached beside traced light: error, time and rays of windows of full-size masters on a scene's lanes, as
// CSV.
//   light_cache_error SCENE.glb FOLDER day|low|overcast VIEWS REFERENCE_SAMPLES
// References are kept in FOLDER, beside pictures to look at: *_cached.png (16 samples), *_traced.png and
// *_difference.png, which shows twelve times their difference on grey. The first cached picture of a view
// includes its cells; `cells` counts all so far.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "files/files.h"
#include "files/png.h"
#include "numbers/angles.h"
#include "numbers/srgb.h"
#include "renderer/aov.h"
#include "renderer/cache/light_cache.h"
#include "scenes/gltf_import.h"
#include "scenes/routes.h"
#include "sensor/develop.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

constexpr int windows_per_view = 8, window_width = 320, window_height = 180;

Daylight daylight_of(const std::string& name) {
  if (name == "overcast") return {.sky = SkyModel::overcast};
  return {.sun_elevation_deg = name == "low" ? 12.0 : 40.0};
}

/// A window of a master of 3840 × 2160 pixels.
Pinhole window(double hfov_deg, int number) {
  Pinhole part = pinhole_from_hfov(3840, 2160, radians(hfov_deg));
  part.cx -= window_width + 960 * (number % 4);
  part.cy -= 700 + 500 * (number / 4);
  part.width = window_width, part.height = window_height;
  return part;
}

/// Means of 2 × 2 pixels, about what a warp makes of a master.
OIIO::ImageBuf halved(const OIIO::ImageBuf& image) {
  const OIIO::ImageSpec& full = image.spec();
  OIIO::ImageBuf half(OIIO::ImageSpec(full.width / 2, full.height / 2, 3, OIIO::TypeDesc::FLOAT));
  for (int y = 0; y < half.spec().height; ++y)
    for (int x = 0; x < half.spec().width; ++x) {
      float sum[3] = {0, 0, 0}, texel[3];
      for (int k = 0; k < 4; ++k) {
        image.getpixel(2 * x + k % 2, 2 * y + k / 2, 0, texel, 3);
        for (int c = 0; c < 3; ++c) sum[c] += texel[c] / 4;
      }
      half.setpixel(x, y, 0, sum);
    }
  return half;
}

struct Error {
  double squares = 0;  ///< mean square, in codes of 255
  double mean = 0;     ///< relative
  double region = 0;   ///< largest relative one of an instance that covers 0.5 % of the window or more
};

double code_of(float radiance, double exposure) {
  return 255 * srgb_from_linear(std::clamp(static_cast<float>(exposure) * radiance, 0.0f, 1.0f));
}

Error error_of(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference, const OIIO::ImageBuf& ids,
               double exposure) {
  Error error;
  const OIIO::ImageBuf a = halved(image), b = halved(reference);
  const std::size_t values = 3 * a.spec().image_pixels();
  const auto *pa = static_cast<const float*>(a.localpixels()),
             *pb = static_cast<const float*>(b.localpixels());
  for (std::size_t i = 0; i < values; ++i)
    error.squares +=
        std::pow(code_of(pa[i], exposure) - code_of(pb[i], exposure), 2) / static_cast<double>(values);

  struct Sums {
    double image = 0, reference = 0, pixels = 0;
  };
  std::map<std::uint32_t, Sums> regions;
  Sums all;
  const float brightest = static_cast<float>(4 / exposure);  // so that a few highlights do not decide
  for (int y = 0; y < window_height; ++y)
    for (int x = 0; x < window_width; ++x)
      for (Sums* sums : {&regions[*static_cast<const std::uint32_t*>(ids.pixeladdr(x, y))], &all}) {
        for (int c = 0; c < 3; ++c) {
          sums->image += std::min(image.getchannel(x, y, 0, c), brightest);
          sums->reference += std::min(reference.getchannel(x, y, 0, c), brightest);
        }
        ++sums->pixels;
      }
  error.mean = all.image / all.reference - 1;
  for (const auto& [id, sums] : regions)
    if (sums.pixels > 0.005 * window_width * window_height)
      error.region = std::max(error.region, std::abs(sums.image / sums.reference - 1));
  return error;
}

void write_picture(const fs::path& file, const OIIO::ImageBuf& linear, double exposure) {
  write_file(file, encode_png(develop(linear, exposure, {}, make_stream(0, "none"))));
}

/// Twelve times the difference, on grey, for an exposure of 1.
OIIO::ImageBuf difference(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference, double exposure) {
  OIIO::ImageBuf shown = halved(image);
  const OIIO::ImageBuf other = halved(reference);
  for (int y = 0; y < shown.spec().height; ++y)
    for (int x = 0; x < shown.spec().width; ++x) {
      float a[3], b[3];
      shown.getpixel(x, y, 0, a, 3), other.getpixel(x, y, 0, b, 3);
      for (int c = 0; c < 3; ++c) a[c] = static_cast<float>(0.2 + 12 * 0.2 * exposure * (a[c] - b[c]));
      shown.setpixel(x, y, 0, a);
    }
  return shown;
}

/// The windows of a view with their references.
struct View {
  std::string name;
  std::vector<Camera> cameras;
  std::vector<OIIO::ImageBuf> references, ids;
  double exposure = 1;
};

View view_of(const Scene& scene, const RenderScene& lit, int number, const std::string& name,
             const fs::path& folder, int reference_samples) {
  const double hfovs_deg[] = {90, 30, 150};
  const Lane& lane = scene.lanes[scene.lanes.size() * (2 * (number % 3) + 1) / 6];
  const Place place = place_on_lane(lane, 0.3 * length_m(lane), 0, 0);
  View view{.name = fmt::format("{}_{:.0f}", name, hfovs_deg[number % 3])};
  std::vector<double> exposures;
  for (int w = 0; w < windows_per_view; ++w) {
    const Camera& camera = view.cameras.emplace_back(
        Camera{.world_from_camera = world_from_vehicle(place) * vehicle_from_camera({}),
               .pinhole = window(hfovs_deg[number % 3], w)});
    const fs::path file = folder / fmt::format("{}_{}_{}.tif", view.name, w, reference_samples);
    OIIO::ImageBuf reference;
    if (fs::exists(file)) {
      reference.reset(file.string());
      reference.read(0, 0, true, OIIO::TypeDesc::FLOAT);
    } else {
      reference = render(lit, camera, {.samples = reference_samples, .seed = 1001});
      reference.write(file.string());
    }
    exposures.push_back(meter_exposure(reference));
    view.references.push_back(std::move(reference));
    view.ids.push_back(render_aovs(lit, camera, {.samples = 1}, {Aov::instance})[0].image);
  }
  std::ranges::nth_element(exposures, exposures.begin() + windows_per_view / 2);
  view.exposure = exposures[windows_per_view / 2];
  return view;
}

/// Renders the windows, prints a line and returns the pictures.
std::vector<OIIO::ImageBuf> measure(const RenderScene& lit, const View& view, LightCache* cache,
                                    int samples) {
  RenderSummary sum;
  Error error;
  std::vector<OIIO::ImageBuf> images;
  for (int w = 0; w < windows_per_view; ++w) {
    RenderSummary summary;
    images.push_back(render(lit, view.cameras[w], {.samples = samples, .seed = 7, .cache = cache}, &summary));
    const Error of_window = error_of(images.back(), view.references[w], view.ids[w], view.exposure);
    error.squares += of_window.squares / windows_per_view;
    error.mean += of_window.mean / windows_per_view;
    error.region = std::max(error.region, of_window.region);
    sum.cpu_s += summary.cpu_s, sum.samples += summary.samples, sum.rays += summary.rays;
  }
  const auto count = static_cast<double>(sum.samples);
  fmt::print("{},{},{},{:.2f},{:.0f},{:.2f},{:.3f},{:+.3f},{:.2f},{}\n", view.name,
             cache ? "cached" : "traced", samples, sum.cpu_s, 1e9 * sum.cpu_s / count,
             static_cast<double>(sum.rays) / count, std::sqrt(error.squares), 100 * error.mean,
             100 * error.region, cache ? cache->summary().cells : 0);
  std::fflush(stdout);
  return images;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    fmt::print(stderr, "light_cache_error SCENE.glb FOLDER day|low|overcast VIEWS REFERENCE_SAMPLES\n");
    return 2;
  }
  const fs::path scene_file = argv[1], folder = argv[2];
  const std::string light = argv[3];
  const Scene scene = import_gltf(scene_file);
  const auto lit = build_render_scene(scene, daylight_of(light));
  LightCache cache(scene, *lit, RenderOptions{}.max_shaded_vertices);
  fs::create_directories(folder);
  fmt::print(
      "view,light,samples,cpu_s,ns_per_sample,rays_per_sample,rmse_codes,mean_percent,region_percent,cells\n");
  for (int v = 0; v < std::atoi(argv[4]); ++v) {
    const View view =
        view_of(scene, *lit, v, scene_file.stem().string() + "_" + light, folder, std::atoi(argv[5]));
    for (const int samples : {2, 4}) measure(*lit, view, nullptr, samples);
    for (const int samples : {2, 1, 2, 4, 4}) measure(*lit, view, &cache, samples);
    const auto converged = measure(*lit, view, &cache, 16);
    for (int w = 0; w < windows_per_view; ++w) {
      const std::string name = fmt::format("{}_{}", view.name, w);
      write_picture(folder / (name + "_cached.png"), converged[w], view.exposure);
      write_picture(folder / (name + "_traced.png"), view.references[w], view.exposure);
      write_picture(folder / (name + "_difference.png"),
                    difference(converged[w], view.references[w], view.exposure), 1);
    }
  }
}
