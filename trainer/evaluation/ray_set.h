#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluation_set.h"

namespace cps {

/// A picture whose camera, of whatever lens family, is known.
struct RayImage {
  std::filesystem::path file;
  std::string name;    ///< for display: the file, relative to its set
  std::string camera;  ///< name of the rig camera, or the name in its source
  std::shared_ptr<const RayTruth> truth;
  int cluster = 0;  ///< equal for images of one place: see bootstrap_intervals()
};

/// Pictures to measure a network on in ray space.
struct RaySet {
  std::string name;
  std::vector<RayImage> images;
};

/// The same pictures as those of Brown–Conrady cameras.
RaySet ray_set(const EvaluationSet& set);

/// One part of a dataset with labels of any family, with place_clusters(). Throws std::runtime_error with one
/// line if the part is empty or a label's lens shows less than half of its image.
RaySet ray_set(const Dataset& dataset, Part part);

/// The pictures in a folder (not in its subfolders), in the order of their names, all taken by this camera.
/// Every picture is a cluster of its own. Throws as the one for datasets.
RaySet ray_set(const std::filesystem::path& folder, const ModelCamera& camera);

/// Whether every label of the part is a Brown–Conrady lens.
bool is_brown_conrady(const Dataset& dataset, Part part);

}  // namespace cps
