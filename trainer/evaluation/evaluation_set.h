#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "distortion/calibrated_camera.h"
#include "trainer/calibration/ray_truth.h"
#include "trainer/calibration/reprojection.h"

namespace cps {

/// A picture whose camera is known.
struct EvaluationImage {
  std::filesystem::path file;
  std::string name;    ///< for display: the file, relative to its set
  std::string camera;  ///< name of the rig camera, or the name in its source
  CalibratedCamera truth;
  std::shared_ptr<const RayGrid> rays;  ///< of the truth
  int cluster = 0;                      ///< equal for images of one place: see bootstrap_intervals()
  std::shared_ptr<const RayTruth> ray_truth = {};
  /// Names the one camera, lens included, that took it and others: the leaf folder in a dataset, else
  /// `camera`.
  std::string taken_by = {};
};

/// Pictures to measure a network on.
struct EvaluationSet {
  std::string name;
  std::vector<EvaluationImage> images;
};

/// The cluster of each of the dataset's images, counted from 0: images with the same number in the same set
/// folder show one place and form a cluster. All images of a panorama (cps relens --panorama) form one, too.
std::vector<int> place_clusters(const Dataset& dataset, std::span<const int> images);

/// One part of a CPS dataset, with place_clusters(). Throws std::runtime_error with one line if the part is
/// empty or a label's lens is not one-to-one.
EvaluationSet evaluation_set(const Dataset& dataset, Part part);

/// The frames that kitti_raw() finds in a folder. Every frame is a cluster of its own.
EvaluationSet kitti_evaluation_set(const std::filesystem::path& folder);

/// The pictures in a folder (not in its subfolders), in the order of their names, all taken by this camera.
/// Every picture is a cluster of its own.
EvaluationSet picture_evaluation_set(const std::filesystem::path& folder, const CalibratedCamera& camera);

}  // namespace cps
