// Cached against traced light: error and cost of views along a scene's lanes, as CSV lines.
//   light_cache_error SCENE.glb FOLDER day|low|overcast WIDTH REFERENCE_SAMPLES
// References are kept in FOLDER, and pictures to look at: *_cached.png, *_traced.png, and *_difference.png,
// twelve times the converged difference on grey.
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "files/files.h"
#include "files/png.h"
#include "numbers/angles.h"
#include "renderer/aov.h"
#include "renderer/cache/light_cache.h"
#include "renderer/paths/render_scene.h"
#include "scenes/gltf_import.h"
#include "scenes/routes.h"
#include "sensor/develop.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

Daylight daylight_of(const std::string& name) {
  if (name == "overcast") return {.sky = SkyModel::overcast};
  return {.sun_elevation_deg = name == "low" ? 12.0 : 40.0};
}

/// As the warp makes them: means of 2 × 2.
OIIO::ImageBuf halved(const OIIO::ImageBuf& image) {
  const OIIO::ImageSpec& full = image.spec();
  OIIO::ImageBuf half(OIIO::ImageSpec(full.width / 2, full.height / 2, 3, OIIO::TypeDesc::FLOAT));
  for (int y = 0; y < full.height / 2; ++y)
    for (int x = 0; x < full.width / 2; ++x) {
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
  double rmse_codes = 0;  ///< of 255, exposed and encoded
  double mean_percent = 0;
};

Error error_of(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference, double exposure) {
  const SensorSettings noiseless{};
  OIIO::ImageBuf a = expose(halved(image), exposure, noiseless),
                 b = expose(halved(reference), exposure, noiseless);
  double squares = 0, sum_a = 0, sum_b = 0;
  const auto encoded = [](float x) {
    x = std::clamp(x, 0.0f, 1.0f);
    return 255 * (x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f);
  };
  const std::size_t count = 3 * a.spec().image_pixels();
  const auto *pa = static_cast<const float*>(a.localpixels()),
             *pb = static_cast<const float*>(b.localpixels());
  for (std::size_t i = 0; i < count; ++i) {
    squares += std::pow(encoded(pa[i]) - encoded(pb[i]), 2);
    sum_a += std::min(pa[i], 4.0f), sum_b += std::min(pb[i], 4.0f);
  }
  return {std::sqrt(squares / static_cast<double>(count)), 100 * (sum_a / sum_b - 1)};
}

/// Largest and 95 % quantile of the regions' difference of means, percent, over regions of at least 0.1 % of
/// the pixels.
std::pair<double, double> region_errors(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference,
                                        const OIIO::ImageBuf& ids) {
  struct Sums {
    double a = 0, b = 0;
    int count = 0;
  };
  std::map<std::uint32_t, Sums> regions;
  const OIIO::ImageSpec& spec = image.spec();
  for (int y = 0; y < spec.height; ++y)
    for (int x = 0; x < spec.width; ++x) {
      Sums& sums = regions[static_cast<const std::uint32_t*>(ids.pixeladdr(x, y))[0]];
      for (int c = 0; c < 3; ++c) {
        sums.a += std::min(image.getchannel(x, y, 0, c), 100.0f);
        sums.b += std::min(reference.getchannel(x, y, 0, c), 100.0f);
      }
      ++sums.count;
    }
  std::vector<double> errors;
  for (const auto& [id, sums] : regions)
    if (sums.count > 1e-3 * spec.width * spec.height && sums.b > 0)
      errors.push_back(100 * std::abs(sums.a / sums.b - 1));
  std::ranges::sort(errors);
  return {errors.back(), errors[errors.size() * 95 / 100]};
}

OIIO::ImageBuf difference(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference, double exposure) {
  OIIO::ImageBuf result(halved(image));
  const OIIO::ImageBuf other = halved(reference);
  for (int y = 0; y < result.spec().height; ++y)
    for (int x = 0; x < result.spec().width; ++x) {
      float a[3], b[3];
      result.getpixel(x, y, 0, a, 3), other.getpixel(x, y, 0, b, 3);
      for (int c = 0; c < 3; ++c) a[c] = static_cast<float>(0.2 + 12 * exposure * (a[c] - b[c]) * 0.2);
      result.setpixel(x, y, 0, a);
    }
  return result;
}

void write_png(const fs::path& file, const OIIO::ImageBuf& linear, double exposure) {
  write_file(file, encode_png(develop(linear, exposure, {}, make_stream(0, "none"))));
}

}  // namespace

/// A window of 320 × 180 pixels of a master of 3840 × 2160.
Pinhole window(double hfov_deg, int i, int j) {
  Pinhole part = pinhole_from_hfov(3840, 2160, radians(hfov_deg));
  part.cx -= 320 + 960 * i;
  part.cy -= 700 + 500 * j;
  part.width = 320, part.height = 180;
  return part;
}

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const fs::path scene_file = argv[1], folder = argv[2];
  const std::string light = argv[3];
  const int views = std::atoi(argv[4]), reference_samples = std::atoi(argv[5]);
  const Scene scene = import_gltf(scene_file);
  const auto ready = build_render_scene(scene, daylight_of(light));
  LightCache cache(scene, *ready, 5);
  fs::create_directories(folder);
  fmt::print(
      "view,way,samples,cpu_s,ns_per_sample,rays_per_sample,rmse_codes,mean_percent,region_max,region_95,cells\n");
  const double hfovs[] = {90, 30, 150};
  for (int v = 0; v < views; ++v) {
    const Lane& lane = scene.lanes[scene.lanes.size() * (2 * v + 1) / 6];
    const Place place = place_on_lane(lane, 0.3 * length_m(lane), 0, 0);
    const std::string name = fmt::format("{}_{}_{:.0f}", scene_file.stem().string(), light, hfovs[v]);
    std::vector<Camera> cameras;
    std::vector<OIIO::ImageBuf> references, ids;
    std::vector<double> exposures;
    for (int k = 0; k < 8; ++k) {
      cameras.push_back({.world_from_camera = world_from_vehicle(place) * vehicle_from_camera({}),
                         .pinhole = window(hfovs[v], k % 4, k / 4)});
      const Camera& camera = cameras.back();
      const fs::path kept = folder / fmt::format("{}_{}_{}.tif", name, k, reference_samples);
      OIIO::ImageBuf reference;
      if (fs::exists(kept)) {
        reference.reset(kept.string());
        reference.read(0, 0, true, OIIO::TypeDesc::FLOAT);
      } else {
        reference = render(*ready, camera, {.samples = reference_samples, .seed = 1001});
        reference.write(kept.string());
      }
      exposures.push_back(meter_exposure(reference));
      references.push_back(reference);
      ids.push_back(render_aovs(*ready, camera, {.samples = 1}, {Aov::instance})[0].image);
    }
    std::sort(exposures.begin(), exposures.end());
    const double exposure = exposures[4];
    const auto line = [&](const char* way, int samples, LightCache* with) {
      RenderSummary sum;
      double squares = 0, mean = 0, most = 0;
      std::vector<OIIO::ImageBuf> images;
      for (int k = 0; k < 8; ++k) {
        RenderSummary summary;
        images.push_back(
            render(*ready, cameras[k], {.samples = samples, .seed = 7, .cache = with}, &summary));
        const Error error = error_of(images.back(), references[k], exposure);
        squares += error.rmse_codes * error.rmse_codes / 8;
        if (getenv("EACH"))
          fmt::print("   {}: rmse {:.2f} cpu {:.2f} rays {:.2f} mean {:+.2f}\n", k, error.rmse_codes,
                     summary.cpu_s, double(summary.rays) / double(summary.samples), error.mean_percent);
        mean += error.mean_percent / 8;
        most = std::max(most, region_errors(images.back(), references[k], ids[k]).first);
        sum.cpu_s += summary.cpu_s, sum.samples += summary.samples, sum.rays += summary.rays;
      }
      fmt::print("{},{},{},{:.2f},{:.0f},{:.2f},{:.3f},{:+.3f},{:.2f},{}\n", name, way, samples, sum.cpu_s,
                 1e9 * sum.cpu_s / static_cast<double>(sum.samples),
                 static_cast<double>(sum.rays) / static_cast<double>(sum.samples), std::sqrt(squares), mean,
                 most, with ? with->summary().cells : 0);
      std::fflush(stdout);
      return images;
    };
    if (!getenv("SHORT")) {
      line("traced", 2, nullptr);
      line("traced", 4, nullptr);
      line("cold", 2, &cache);
      line("cached", 1, &cache);
      line("cached", 2, &cache);
      line("cached", 4, &cache);
    }
    const auto converged = line("cached", 16, &cache);
    if (getenv("SHORT")) return 0;
    for (int k = 0; k < 8; ++k) {
      write_png(folder / fmt::format("{}_{}_cached.png", name, k), converged[k], exposure);
      write_png(folder / fmt::format("{}_{}_traced.png", name, k), references[k], exposure);
      write_png(folder / fmt::format("{}_{}_difference.png", name, k),
                difference(converged[k], references[k], exposure), 1.0);
    }
  }
}
