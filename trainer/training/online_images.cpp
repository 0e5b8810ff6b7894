#include "trainer/training/online_images.h"

#include <algorithm>
#include <stdexcept>

#include "dataset/job/recipe_json.h"
#include "distortion/label_algebra.h"
#include "sensor/develop.h"
#include "trainer/images/master_cache.h"
#include "trainer/training/online_lens.h"

namespace cps {
namespace {

struct OnlineImages {
  MasterCache cache;
  OnlineLensOptions lenses;
  SensorOptions sensor;
  TrainOptions options;

  GrayImage developed(int i, const DrawnLens& lens, Stream stream) const {
    const KeptMaster& master = cache.masters[i];
    const Stream noise = make_stream(stream.key, "sensor");
    const OIIO::ImageBuf image =
        develop(warp(cache.gray(i), master.camera, lens.distortion, lens.crop.camera,
                     {.box = frame_on_plane(lens.base)}),
                master.exposure, draw_sensor(sensor, make_stream(noise.key, "settings")),
                make_stream(noise.key, "noise"));
    const auto* pixels = static_cast<const std::uint8_t*>(image.localpixels());
    const ImageSize size{image.spec().width, image.spec().height};
    return area_average({size, {pixels, pixels + pixel_count(size)}}, reduced_size(size, options.reduction));
  }

  ShownImage shown(int i, int epoch) const {
    const Stream stream = substream(substream(make_stream(options.seed, "online lenses"), epoch), i);
    const DrawnLens lens = draw_online_lens(cache.masters[i], lenses, make_stream(stream.key, "lens"));
    ShownImage image{.pixels = developed(i, lens, stream),
                     .original = {lens.crop.camera.width, lens.crop.camera.height},
                     .is_mirrored = options.mirror && is_mirrored(options.seed, epoch, i)};
    CalibratedCamera camera{"", lens.crop.camera, lens.distortion};
    if (image.is_mirrored) camera = mirrored_left_right(camera);
    image.target = to_outputs(camera, options.target_space);
    if (options.loss == Loss::reprojection)
      image.rays = loss_rays(camera, frame_on_plane(lens.base), cache.masters[i].file.string());
    return image;
  }
};

/// Images and targets as they might be before the first epoch, evenly spread over the masters.
void add_statistics(TrainingSet& set) {
  constexpr int most = 4096;
  const int masters = static_cast<int>(set.originals.size()), count = std::min(masters, most);
  Batch batch;
  for (int n = 0; n < count; ++n)
    batch.push_back(static_cast<int>(static_cast<std::int64_t>(n) * masters / count));
  const std::vector<ShownImage> shown = show(set, batch, TrainOptions{}, 0);
  std::vector<GrayView> pixels;
  std::vector<Outputs> targets;
  for (const ShownImage& image : shown) {
    pixels.push_back({image.pixels.size, image.pixels.pixels.data()});
    targets.push_back(image.target);
  }
  set.pixels = pixel_statistics(pixels);
  set.targets = fit_standardisation(targets);
}

}  // namespace

TrainingSet online_images(const Dataset& dataset, const TrainOptions& options,
                          const std::filesystem::path& cache_file) {
  const Recipe recipe = read_recipe(dataset.root);
  if (recipe.lens_options.coefficients.has_k1_range())
    throw std::runtime_error((dataset.root / "dataset.json").string() +
                             ": recipe: k1_min, k1_max: are told by the base's H-FOV, online lenses by the "
                             "image's: train on the images, or make a dataset without them");
  const int lenses = *std::ranges::max_element(recipe.lenses.values);
  auto images = std::make_shared<OnlineImages>(
      OnlineImages{.cache = load_master_cache(dataset.root, Part::train, options.skip_bad_images, cache_file),
                   .lenses = {.lens = recipe.lens_options,
                              .undistorted_share = recipe.undistorted ? 1.0 / (lenses + 1) : 0,
                              .zoom = options.online_zoom},
                   .sensor = recipe.sensor,
                   .options = options});
  TrainingSet set{
      .originals = {}, .pixels = {}, .targets = {}, .skipped = images->cache.skipped, .shown = {}};
  for (const KeptMaster& master : images->cache.masters)
    set.originals.push_back({master.base.width, master.base.height});
  set.shown = [images](int i, int epoch) { return images->shown(i, epoch); };
  add_statistics(set);
  return set;
}

}  // namespace cps
