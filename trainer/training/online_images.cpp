#include "trainer/training/online_images.h"

#include <algorithm>
#include <stdexcept>

#include "dataset/job/recipe_json.h"
#include "dataset/pixels/image_file.h"
#include "distortion/label_algebra.h"
#include "trainer/images/master_cache.h"
#include "trainer/images/orientation/measure.h"
#include "trainer/training/online_lens.h"

namespace cps {
namespace {

struct OnlineImages {
  MasterCache cache;
  OnlineLensOptions lenses;
  SensorOptions sensor;
  StoredFormat stored;
  TrainOptions options;

  ShownImage shown(int i, int epoch) const {
    const Stream stream = substream(substream(make_stream(options.seed, "online lenses"), epoch), i);
    const DrawnLens lens = draw_online_lens(cache.masters[i], lenses, make_stream(stream.key, "lens"));
    const GrayImage whole = online_image(cache.master(i), cropped(lens),
                                         sensor_of(sensor, make_stream(stream.key, "sensor")), stored);
    ShownImage image{.pixels = area_average(whole, reduced_size(whole.size, options.reduction)),
                     .original = {lens.crop.camera.width, lens.crop.camera.height},
                     .is_mirrored = options.mirror && is_mirrored(options.seed, epoch, i)};
    if (options.orientation.measured)
      image.measured = measured_picture(whole, image.pixels.size, options.orientation.max_width);
    CalibratedCamera camera{"", lens.crop.camera, lens.distortion};
    if (image.is_mirrored) camera = mirrored_left_right(camera);
    image.target = to_outputs(camera, options.target_space);
    if (options.loss == Loss::reprojection)
      image.rays = loss_rays(camera, frame_on_plane(lens.base), cache.masters[i].file.string());
    return image;
  }
};

/// Statistics of images and targets as epoch 0 would show them, over masters evenly spread over the set.
void add_statistics(TrainingSet& set) {
  constexpr int max_masters = 4096;
  const int masters = static_cast<int>(set.originals.size()), count = std::min(masters, max_masters);
  Batch batch;
  for (int n = 0; n < count; ++n)
    batch.push_back(static_cast<int>(static_cast<std::int64_t>(n) * masters / count));
  const std::vector<ShownImage> shown = show(set, batch, TrainOptions{}, 0);
  std::vector<GrayView> pixels;
  std::vector<OrientationView> orientations;
  std::vector<Outputs> targets;
  for (const ShownImage& image : shown) {
    pixels.push_back({image.pixels.size, image.pixels.pixels.data()});
    if (!image.orientation.planes.empty()) orientations.push_back(view_of(image.orientation));
    targets.push_back(image.target);
  }
  set.pixels = pixel_statistics(pixels);
  if (!orientations.empty()) set.orientation = orientation_statistics(orientations);
  set.targets = fit_standardisation(targets);
  set.correlation = correlation(targets);
}

}  // namespace

GrayImage online_image(const Master& master, const CroppedLens& lens, const Sensor& sensor,
                       const StoredFormat& stored) {
  const OIIO::ImageBuf image = photograph(master, lens, sensor, pixel_format_of(stored.format));
  const OIIO::ImageBuf pixels =
      stored_pixels(image, stored.format, stored.jpeg_quality).copy(OIIO::TypeDesc::UINT8);
  return gray_of({pixels.spec().width, pixels.spec().height}, pixels.spec().nchannels,
                 static_cast<const std::uint8_t*>(pixels.localpixels()));
}

TrainingSet online_images(const Dataset& dataset, const TrainOptions& options,
                          const std::filesystem::path& cache_file) {
  const Recipe recipe = read_recipe(dataset.root);
  if (recipe.lens_options.coefficients.has_k1_range())
    throw std::runtime_error(
        (dataset.root / "dataset.json").string() +
        ": recipe: k1_min, k1_max: apply to lenses drawn for the base's H-FOV, and online lenses are drawn "
        "for the image's: train on the images, or make a dataset without them");
  const StoredFormat stored{recipe.image_format, recipe.jpeg_quality};
  const int lenses = *std::ranges::max_element(recipe.lenses.values);
  auto images = std::make_shared<OnlineImages>(OnlineImages{
      .cache = load_master_cache(dataset.root, Part::train, stored.format == ImageFormat::png_gray,
                                 options.skip_bad_images, cache_file, options.places_share),
      .lenses = {.lens = recipe.lens_options,
                 .undistorted_share = recipe.undistorted ? 1.0 / (lenses + 1) : 0,
                 .zoom = options.online_zoom},
      .sensor = recipe.sensor,
      .stored = stored,
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
