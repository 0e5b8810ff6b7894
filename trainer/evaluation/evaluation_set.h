#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "distortion/calibrated_camera.h"
#include "trainer/calibration/reprojection.h"

namespace cps {

/// Pictures whose lens is known, wherever they come from.
struct EvaluationImage {
  std::filesystem::path file;
  std::string name;    ///< for people: the file, relative to its set
  std::string camera;  ///< rig camera, or whatever its source calls it
  Calibration truth;
  std::shared_ptr<const RayGrid> rays;  ///< of the truth
  int cluster = 0;                      ///< images of one place share theirs: see bootstrap_intervals()
};

struct EvaluationSet {
  std::string name;
  std::vector<EvaluationImage> images;
};

/// A part of a CPS dataset. Images of one set with one number show one place and are a cluster. Throws
/// std::runtime_error with one line when the part is empty or a label's lens is not one-to-one.
EvaluationSet evaluation_set(const Dataset& dataset, Part part);

/// kitti_raw() of a folder. Every frame is a cluster.
EvaluationSet kitti_evaluation_set(const std::filesystem::path& folder);

/// The pictures in a folder (not below it), in the order of their names, all of this camera. Every picture is
/// a cluster.
EvaluationSet picture_evaluation_set(const std::filesystem::path& folder, const CalibratedCamera& camera);

}  // namespace cps
