#include "apps/pictures/camera_set.h"

#include <fmt/format.h>

#include <stdexcept>

#include "apps/pictures/picture_file.h"
#include "apps/progress.h"
#include "dataset/exchange/camera_pictures.h"
#include "dataset/exchange/model_calibration.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/warp_models.h"
#include "files/files.h"
#include "numbers/angles.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

/// A camera of any family and pictures that it took.
struct SourcePictures {
  ModelCamera camera;
  std::vector<fs::path> files;
};

std::vector<SourcePictures> pictures_of(const CameraSource& source) {
  std::vector<SourcePictures> cameras;
  if (!source.kitti.empty())
    for (const CameraPictures& c : kitti_raw(source.kitti)) {
      cameras.push_back({model_camera(c.camera), c.files});
      cameras.back().camera.name = "kitti" + c.camera.name;
    }
  if (!source.pictures.empty())
    cameras.push_back({read_model_camera(source.lens, source.lens_camera), pictures_in(source.pictures)});
  return cameras;
}

/// The camera of the straightened pictures. Throws std::runtime_error naming the camera.
Pinhole straight_camera(const CameraSource& wanted, const ModelCamera& source) {
  const int width = source.pinhole.width, height = source.pinhole.height;
  const auto* lens = std::get_if<Distortion>(&source.lens);
  const ViewFit widest = lens != nullptr
                             ? fit_straight_view(CalibratedCamera{source.name, source.pinhole, *lens},
                                                 Keep::valid, width, height, .5)
                             : fit_straight_view(source, Keep::valid, width, height, .5);
  if (!widest.valid) throw std::runtime_error("camera " + source.name + ": " + widest.why);
  const double widest_deg = degrees(hfov_rad(widest.camera));
  if (wanted.straight_hfov_deg > widest_deg)
    throw std::runtime_error(fmt::format("camera {}: --straight-hfov {:g}: its pictures fill {:.2f} degrees",
                                         source.name, wanted.straight_hfov_deg, widest_deg));
  constexpr double widest_by_itself_deg = 120;  // beyond, most of a straight picture is its stretched rim
  const double limit_deg = wanted.straight_hfov_deg > 0 ? wanted.straight_hfov_deg
                           : lens != nullptr            ? widest_deg
                                                        : widest_by_itself_deg;
  if (limit_deg >= widest_deg) return widest.camera;
  return pinhole_from_hfov(width, height, radians(limit_deg));
}

OIIO::ImageBuf straightened(const OIIO::ImageBuf& picture, const ModelCamera& source,
                            const Pinhole& straight) {
  const WarpOptions options{.oversampling = 1, .require_coverage = false, .require_resolution = false};
  if (const auto* lens = std::get_if<Distortion>(&source.lens))
    return unwarp(picture, source.pinhole, *lens, straight, options);
  return warp_between(picture, source, {source.name, straight, Distortion{}}, options);
}

/// Straightens each picture and warps it through every lens. Only warps: the pictures have passed a sensor,
/// whose exposure and noise they keep, so photograph() has nothing to add. Returns the names of the files
/// written.
std::string make_images(const SourcePictures& source, const Pinhole& straight,
                        const std::vector<RelensGroup>& groups, const fs::path& root, Progress& progress) {
  std::string names;
  const WarpOptions bend{.oversampling = 1};
  for (std::size_t i = 0; i < source.files.size(); ++i) {
    const Pinhole& camera = source.camera.pinhole;
    const Picture picture = read_picture(source.files[i], Encoding::automatic, Resampling::footprint,
                                         camera.width, camera.height);
    const OIIO::ImageBuf ideal = straightened(picture.pixels, source.camera, straight);
    for (const RelensGroup& group : groups) {
      const std::string name = fmt::format("{}/{:06}.png", group.folder, i);
      write_picture(root / name, warp(ideal, straight, group.label.distortion, group.label.camera, bend),
                    picture);
      names += name + "\n";
      progress.advance(1, name);
    }
  }
  return names;
}

}  // namespace

void make_camera_set(const CameraSource& source, const fs::path& root, const RelensOptions& options) {
  const std::vector<SourcePictures> cameras = pictures_of(source);
  std::int64_t images = 0;
  for (const SourcePictures& c : cameras)
    images += static_cast<std::int64_t>(c.files.size()) * options.lenses;
  Progress progress("images", 0, images);
  std::string names;
  int first_lens = 1;
  for (const SourcePictures& taken : cameras) {
    const Pinhole straight = straight_camera(source, taken.camera);
    const std::vector<RelensGroup> groups =
        draw_relens_groups(straight, taken.camera.name, first_lens, options);
    first_lens += static_cast<int>(groups.size());
    for (const RelensGroup& group : groups)
      write_json(root / group.folder / "calibration.json", to_json(group.label));
    names += make_images(taken, straight, groups, root, progress);
  }
  for (const char* part : {"train", "val"}) write_file(root / "splits" / (std::string(part) + ".txt"), {});
  write_file(root / "splits/test.txt", names);
  progress.finish();
}

}  // namespace cps
