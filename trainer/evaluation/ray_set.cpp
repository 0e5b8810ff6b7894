#include "trainer/evaluation/ray_set.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "dataset/exchange/camera_pictures.h"
#include "trainer/training/samples.h"

namespace cps {
namespace {

std::shared_ptr<const RayTruth> truth_of(const ModelCamera& camera, const std::string& where) {
  std::shared_ptr<const RayTruth> truth = ray_truth(camera);
  if (!truth)
    throw std::runtime_error(
        where + ": the lens is not one-to-one, or shows less than half of its frame: see cps lens check");
  return truth;
}

}  // namespace

RaySet ray_set(const EvaluationSet& set) {
  RaySet result{.name = set.name, .images = {}};
  for (const EvaluationImage& image : set.images)
    result.images.push_back({image.file, image.name, image.camera, image.ray_truth, image.cluster});
  return result;
}

RaySet ray_set(const Dataset& dataset, Part part) {
  if (is_brown_conrady(dataset, part)) return ray_set(evaluation_set(dataset, part));
  RaySet set{.name = to_string(part) + " images of " + dataset.root.string(), .images = {}};
  std::map<int, std::shared_ptr<const RayTruth>> of_group;
  const std::vector<int> images = images_of(dataset, part), clusters = place_clusters(dataset, images);
  for (std::size_t k = 0; k < images.size(); ++k) {
    const DatasetImage& image = dataset.images[images[k]];
    const DatasetGroup& group = dataset.groups[image.group];
    auto& truth = of_group[image.group];
    if (!truth) truth = truth_of(group.camera(), (dataset.root / group.folder / "calibration.json").string());
    set.images.push_back(
        {dataset.root / image.file, image.file.string(), group.label.rig_camera, truth, clusters[k]});
  }
  return set;
}

RaySet ray_set(const std::filesystem::path& folder, const ModelCamera& camera) {
  RaySet set{.name = "pictures in " + folder.string(), .images = {}};
  const auto truth = truth_of(camera, "camera " + camera.name);
  for (const std::filesystem::path& file : pictures_in(folder))
    set.images.push_back(
        {file, file.filename().string(), camera.name, truth, static_cast<int>(set.images.size())});
  return set;
}

bool is_brown_conrady(const Dataset& dataset, Part part) {
  return std::ranges::none_of(images_of(dataset, part), [&](int image) {
    return dataset.groups[dataset.images[image].group].model.has_value();
  });
}

}  // namespace cps
