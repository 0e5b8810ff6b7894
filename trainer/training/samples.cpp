#include "trainer/training/samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "distortion/label_algebra.h"
#include "trainer/images/blob_cache.h"
#include "trainer/images/places.h"

namespace cps {

std::vector<int> images_of(const Dataset& dataset, Part part) {
  std::vector<int> images;
  for (int i = 0; i < static_cast<int>(dataset.images.size()); ++i)
    if (dataset.images[i].part == part) images.push_back(i);
  return images;
}

namespace {

std::string label_file(const Dataset& dataset, const DatasetGroup& group) {
  return (dataset.root / group.folder / "calibration.json").string();
}

SphereTarget sphere_target_of(const Dataset& dataset, const DatasetGroup& group) {
  return to_sphere_target(group.camera(), label_file(dataset, group));
}

void refuse_other_family(const Dataset& dataset, const DatasetGroup& group) {
  if (group.model)
    throw std::runtime_error(label_file(dataset, group) + ": model: is " +
                             std::string(family_name(group.model->camera.lens)) +
                             ": this network learns brown_conrady lenses; for unified_spherical choose the "
                             "preset deepcalib-regression or deepcalib-classification");
}

/// The images' pixels. Unusable images are removed from `images` if the options allow it.
ImageCache usable_images(const Dataset& dataset, std::vector<int>& images, const SampleOptions& options,
                         const std::filesystem::path& cache_file, std::vector<std::string>& skipped) {
  for (;;) try {
      return load_image_cache(dataset, images, options.reduction, cache_file, options.orientation);
    } catch (const BadBlobs& bad) {
      if (!options.skip_bad_images || bad.positions.size() == images.size()) throw;
      leave_out(bad, images, skipped);
    }
}

/// Adds the ray grids; the images of a group share one.
void add_rays(Samples& samples, const Dataset& dataset, const std::vector<int>& images) {
  std::map<int, std::array<std::shared_ptr<const RayGrid>, 2>> of_group;
  for (int i : images) {
    const int group = dataset.images[i].group;
    auto& grids = of_group[group];
    if (!grids[0]) {
      const DatasetGroup& g = dataset.groups[group];
      const std::string label = label_file(dataset, g);
      const CalibratedCamera camera{"", g.label.camera, g.label.distortion};
      const Eigen::AlignedBox2d shape = frame_on_plane(base_of(g.label));  // also the mirrored lens' shape
      grids = {loss_rays(camera, shape, label), loss_rays(mirrored_left_right(camera), shape, label)};
    }
    samples.rays.push_back(grids[0]);
    samples.mirrored_rays.push_back(grids[1]);
  }
}

void add_targets(Samples& samples, const Dataset& dataset, const DatasetGroup& group, TargetSpace space) {
  refuse_other_family(dataset, group);
  const CalibratedCamera camera{"", group.label.camera, group.label.distortion};
  samples.targets.push_back(to_outputs(camera, space));
  samples.mirrored_targets.push_back(to_outputs(mirrored_left_right(camera), space));
  if (!std::ranges::all_of(samples.targets.back(), [](double v) { return std::isfinite(v); }))
    throw std::runtime_error(label_file(dataset, group) +
                             ": holds a number that is not finite: make this group again");
}

}  // namespace

void require_learnable(const Dataset& dataset, Head head) {
  std::vector<bool> is_checked(dataset.groups.size(), false);
  for (const DatasetImage& image : dataset.images) {
    if (image.part == Part::test || is_checked[image.group]) continue;
    is_checked[image.group] = true;
    const DatasetGroup& group = dataset.groups[image.group];
    if (is_deepcalib(head))
      sphere_target_of(dataset, group);
    else
      refuse_other_family(dataset, group);
  }
}

Samples load_samples(const Dataset& dataset, Part part, const SampleOptions& options,
                     const std::filesystem::path& cache_file) {
  std::vector<int> images = share_of_places(dataset, images_of(dataset, part), options.places_share);
  if (images.empty())
    throw std::runtime_error((dataset.root / "splits" / (to_string(part) + ".txt")).string() +
                             ": lists no image: make a dataset with more places or routes");
  Samples samples;
  samples.cache = usable_images(dataset, images, options, cache_file, samples.skipped);
  for (int i : images) {
    const DatasetGroup& group = dataset.groups[dataset.images[i].group];
    if (is_deepcalib(options.head))
      samples.spheres.push_back(sphere_target_of(dataset, group));
    else
      add_targets(samples, dataset, group, options.space);
  }
  if (options.with_rays) add_rays(samples, dataset, images);
  return samples;
}

}  // namespace cps
