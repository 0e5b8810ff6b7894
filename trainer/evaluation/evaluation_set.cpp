#include "trainer/evaluation/evaluation_set.h"

#include <map>
#include <stdexcept>

#include "dataset/exchange/camera_pictures.h"
#include "trainer/training/samples.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const RayGrid> shared(std::optional<RayGrid> rays, const std::string& where) {
  if (!rays)
    throw std::runtime_error(where + ": the lens is not one-to-one in its frame: see cps lens check");
  return std::make_shared<const RayGrid>(std::move(*rays));
}

}  // namespace

EvaluationSet evaluation_set(const Dataset& dataset, Part part) {
  EvaluationSet set{.name = to_string(part) + " images of " + dataset.root.string(), .images = {}};
  std::map<int, std::shared_ptr<const RayGrid>> rays;  // by group
  std::map<std::string, int> places;                   // <set folder>/<file name>
  for (int i : images_of(dataset, part)) {
    const DatasetImage& image = dataset.images[i];
    const DatasetGroup& group = dataset.groups[image.group];
    const CalibratedCamera truth{group.label.rig_camera, group.label.camera, group.label.distortion};
    auto& grid = rays[image.group];
    if (!grid)
      grid = shared(ray_grid(truth, frame_on_plane(base_of(group.label))),
                    (dataset.root / group.folder / "calibration.json").string());
    const std::string place = (group.folder.parent_path() / image.file.filename()).string();
    const int cluster = places.try_emplace(place, static_cast<int>(places.size())).first->second;
    set.images.push_back(
        {dataset.root / image.file, image.file.string(), group.label.rig_camera, truth, grid, cluster});
  }
  if (set.images.empty())
    throw std::runtime_error((dataset.root / "splits" / (to_string(part) + ".txt")).string() +
                             ": lists no image: choose another --part or dataset");
  return set;
}

EvaluationSet kitti_evaluation_set(const fs::path& folder) {
  EvaluationSet set{.name = "KITTI raw frames of " + folder.string(), .images = {}};
  for (const CameraPictures& pictures : kitti_raw(folder)) {
    const auto rays = shared(ray_grid(pictures.camera), folder.string() + ": camera " + pictures.camera.name);
    for (const fs::path& file : pictures.files)
      set.images.push_back({file, file.lexically_relative(folder).string(), "KITTI " + pictures.camera.name,
                            pictures.camera, rays, static_cast<int>(set.images.size())});
  }
  return set;
}

EvaluationSet picture_evaluation_set(const fs::path& folder, const CalibratedCamera& camera) {
  EvaluationSet set{.name = "pictures in " + folder.string(), .images = {}};
  const auto rays = shared(ray_grid(camera), "camera " + camera.name);
  for (const fs::path& file : pictures_in(folder))
    set.images.push_back(
        {file, file.filename().string(), camera.name, camera, rays, static_cast<int>(set.images.size())});
  return set;
}

}  // namespace cps
