#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "sampler/plan/plan.h"

namespace cps {

/// One line of frames.csv: an image and how it came about.
struct Frame {
  const PlannedView* view;
  const ViewRecord* record;
  const ImageRecord* image;
};

/// frames.csv of one leaf folder: a header and a line per image. Poses are world from camera: position in
/// metres (glTF's frame, y up) and unit quaternion w x y z of the camera frame (x right, y down, z forward).
std::string frames_csv(const std::vector<Frame>& frames);

/// What a checker needs of one line.
struct FrameRow {
  std::string file, part, condition, street, sha256;
  double exposure = 1, exposure_bias_ev = 0;
};

/// Reads a frames.csv by its header's names, whatever their order. Throws std::runtime_error: file, line,
/// what.
std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file);

}  // namespace cps
