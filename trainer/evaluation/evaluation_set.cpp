#include "trainer/evaluation/evaluation_set.h"

#include <map>
#include <stdexcept>

#include "dataset/exchange/camera_pictures.h"
#include "trainer/images/places.h"
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

std::vector<int> place_clusters(const Dataset& dataset, std::span<const int> images) {
  std::map<std::string, int> places;
  std::vector<int> clusters;
  for (int i : images) {
    const std::string place = place_of(dataset, dataset.images[i]);
    clusters.push_back(places.try_emplace(place, static_cast<int>(places.size())).first->second);
  }
  return clusters;
}

EvaluationSet evaluation_set(const Dataset& dataset, Part part) {
  EvaluationSet set{.name = to_string(part) + " images of " + dataset.root.string(), .images = {}};
  struct Rays {
    std::shared_ptr<const RayGrid> grid;
    std::shared_ptr<const RayTruth> truth;
  };
  std::map<int, Rays> of_group;
  const std::vector<int> images = images_of(dataset, part), clusters = place_clusters(dataset, images);
  for (std::size_t k = 0; k < images.size(); ++k) {
    const DatasetImage& image = dataset.images[images[k]];
    const DatasetGroup& group = dataset.groups[image.group];
    const CalibratedCamera truth{group.label.rig_camera, group.label.camera, group.label.distortion};
    Rays& rays = of_group[image.group];
    if (!rays.grid) {
      const Eigen::AlignedBox2d shape = frame_on_plane(base_of(group.label));
      rays.grid = shared(ray_grid(truth, shape), (dataset.root / group.folder / "calibration.json").string());
      rays.truth = ray_truth(truth, *rays.grid, shape);
    }
    set.images.push_back({dataset.root / image.file, image.file.string(), group.label.rig_camera, truth,
                          rays.grid, clusters[k], rays.truth, group.folder.string()});
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
    const auto truth = ray_truth(pictures.camera, *rays, frame_on_plane(pictures.camera.pinhole));
    const std::string name = "KITTI " + pictures.camera.name;
    for (const fs::path& file : pictures.files)
      set.images.push_back({file, file.lexically_relative(folder).string(), name, pictures.camera, rays,
                            static_cast<int>(set.images.size()), truth, name});
  }
  return set;
}

EvaluationSet picture_evaluation_set(const fs::path& folder, const CalibratedCamera& camera) {
  EvaluationSet set{.name = "pictures in " + folder.string(), .images = {}};
  const auto rays = shared(ray_grid(camera), "camera " + camera.name);
  const auto truth = ray_truth(camera, *rays, frame_on_plane(camera.pinhole));
  for (const fs::path& file : pictures_in(folder))
    set.images.push_back({file, file.filename().string(), camera.name, camera, rays,
                          static_cast<int>(set.images.size()), truth, camera.name});
  return set;
}

}  // namespace cps
