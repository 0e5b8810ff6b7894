#include "apps/pictures/panorama_set.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_format.h"
#include "apps/progress.h"
#include "dataset/labels/group_label.h"
#include "dataset/labels/model_label.h"
#include "distortion/panorama/panorama_warp.h"
#include "files/files.h"
#include "files/png.h"
#include "sensor/develop.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

struct PlannedPanorama {
  fs::path file;
  PanoramaSource source;
  std::vector<PanoramaView> views;
};

std::vector<fs::path> files_in(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": is not a folder of panoramas");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && picture_format(entry.path()) != nullptr) files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error(folder.string() + ": has no pictures in it");
  std::ranges::sort(files);
  return files;
}

std::vector<PlannedPanorama> plan(const fs::path& folder, const PanoramaSetOptions& options) {
  std::vector<PlannedPanorama> panoramas;
  for (const fs::path& file : files_in(folder)) {
    const ImageSize size = upright_size(file);
    if (size.width != 2 * size.height)
      throw std::runtime_error(fmt::format(
          "{}: is {} x {} pixels: an equirectangular panorama is twice as wide as high; remove it or pad it",
          file.string(), size.width, size.height));
    const PanoramaSource source{file.stem().string(), size.width};
    const auto same = std::ranges::find(panoramas, source.name,
                                        [](const PlannedPanorama& planned) { return planned.source.name; });
    if (same != panoramas.end())
      throw std::runtime_error(file.string() + ": has the name of " + same->file.filename().string() +
                               ": rename or remove one of them");
    try {
      panoramas.push_back({file, source, draw_panorama_views(source, options)});
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  }
  return panoramas;
}

/// What meters and develops: three channels, without alpha.
OIIO::ImageBuf three_channels(const OIIO::ImageBuf& image) {
  if (image.nchannels() == 3) return image;
  const std::array<int, 3> colours{0, 1, 2}, gray{0, 0, 0};
  return OIIO::ImageBufAlgo::channels(image, 3, image.nchannels() == 4 ? colours : gray);
}

/// Writes an image as a render is written: metered, with the noise of a drawn sensor, as 8-bit sRGB.
void write_developed(const fs::path& file, const OIIO::ImageBuf& picture, Stream stream) {
  const OIIO::ImageBuf light = three_channels(picture);
  const Sensor sensor = sensor_of(SensorOptions{}, stream);
  write_file(file, encode_png(develop(light, meter_exposure(light), sensor.settings, sensor.noise)));
}

void make_views(const PlannedPanorama& panorama, const fs::path& root, const PanoramaSetOptions& options,
                Progress& progress) {
  const int width = panorama.source.width;
  const Picture picture =
      read_picture(panorama.file, Encoding::automatic, Resampling::footprint, width, width / 2);
  const bool is_developed = picture.file.format.is_floating_point();
  const Stream sensors =
      substream(make_stream(options.seed, "panorama sensors"), make_stream(0, panorama.source.name).key);
  for (std::size_t i = 0; i < panorama.views.size(); ++i) {
    const PanoramaView& view = panorama.views[i];
    const fs::path file = root / view.folder / "000000.png";
    const OIIO::ImageBuf image =
        photograph_panorama(picture.pixels, panorama_from_camera(view.yaw_rad, view.pitch_rad, view.roll_rad),
                            view.camera, {.oversampling = 1});
    if (is_developed)
      write_developed(file, image, substream(sensors, i));
    else
      write_picture(file, image, picture);
    write_json(root / view.folder / "calibration.json", view.label);
    progress.advance(1, view.folder);
  }
}

/// Writes the split lists. Returns the number of images in train, val and test.
std::array<std::size_t, 3> write_lists(const std::vector<PlannedPanorama>& panoramas, const fs::path& root) {
  std::array<std::size_t, 3> counts{};
  for (const Part part : {Part::train, Part::val, Part::test}) {
    std::string names;
    for (const PlannedPanorama& panorama : panoramas)
      for (const PanoramaView& view : panorama.views)
        if (view.part == part) {
          names += view.folder + "/000000.png\n";
          ++counts[static_cast<std::size_t>(part)];
        }
    write_file(root / "splits" / (to_string(part) + ".txt"), names);
  }
  return counts;
}

nlohmann::ordered_json origin_json(const std::vector<PlannedPanorama>& panoramas,
                                   const PanoramaSetOptions& options) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const PlannedPanorama& panorama : panoramas)
    files.push_back({{"file", panorama.file.filename().string()},
                     {"width", panorama.source.width},
                     {"part", to_string(part_of_panorama(panorama.source.name))},
                     {"sha256", sha256(read_file(panorama.file))}});
  const auto ends = [](const Interval& interval) {
    return nlohmann::ordered_json{interval.low, interval.high};
  };
  const bool has_focal = options.focal_px.high > 0;
  return {{"lens_model", options.family},
          {has_focal ? "focal_px" : "hfov_deg", ends(has_focal ? options.focal_px : options.hfov_deg)},
          {"pitch_deg", ends(options.pitch_deg)},
          {"roll_deg", ends(options.roll_deg)},
          {"views", options.views},
          {"size", {options.size.width, options.size.height}},
          {"seed", options.seed},
          {"generator", generator_name()},
          {"panoramas", files}};
}

nlohmann::ordered_json description_json(const PanoramaSetOptions& options, std::size_t images) {
  nlohmann::ordered_json json = other_family_json(options.family);
  json["images"] = images;
  json["generator"] = generator_name();
  return json;
}

}  // namespace

void make_panorama_set(const fs::path& folder, const fs::path& root, const PanoramaSetOptions& options) {
  const std::vector<PlannedPanorama> panoramas = plan(folder, options);
  const std::size_t images = panoramas.size() * static_cast<std::size_t>(options.views);
  Progress progress("images", 0, static_cast<std::int64_t>(images));
  for (const PlannedPanorama& panorama : panoramas) make_views(panorama, root, options, progress);
  write_json(root / "panoramas.json", origin_json(panoramas, options));
  const auto [train, val, test] = write_lists(panoramas, root);
  if (options.family != "brown_conrady") write_json(root / "dataset.json", description_json(options, images));
  progress.finish();
  fmt::print("{}: {} panoramas, {} images: {} train, {} val, {} test\n", root.string(), panoramas.size(),
             images, train, val, test);
}

}  // namespace cps
