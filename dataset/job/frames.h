#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "files/csv.h"
#include "sampler/part.h"
#include "sampler/plan/plan.h"

/// frames.csv: a table in every leaf folder, with a line for each image and how it came about.
namespace cps {

/// Where the plan and the records keep what a line says.
struct Frame {
  const PlannedView* view;
  const ViewRecord* record;
  const ImageRecord* image;
};

/// One line. The world frame is glTF's: y up, metres.
struct FrameRow {
  std::string file;            ///< name in the leaf folder
  Part part = Part::train;     ///< never `all`
  std::int64_t condition = 0;  ///< index into the conditions of dataset.json
  std::string street;
  Place vehicle;
  /// World from camera (x right, y down, z forward): position in metres and unit quaternion. The drawn mount
  /// errors are in it.
  Eigen::Vector3d camera_position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond camera_rotation = Eigen::Quaterniond::Identity();
  double exposure = 1;  ///< metered
  SensorSettings sensor;
  std::string sha256;  ///< of the image's file
};

/// The pose of the camera as one transform. The quaternion is normalised.
Eigen::Isometry3d world_from_camera(const FrameRow& row);

FrameRow frame_row(const Frame& frame);

/// One column: header, writer, reader and the comparison with a plan all go through the table of them.
struct FrameColumn {
  const char* name;
  bool is_planned;  ///< decided by the plan; the other columns are measured or drawn while images are made
  std::string (*write)(const FrameRow& row);
  /// Throws std::runtime_error, file, line and column first.
  void (*read)(const CsvCell& cell, FrameRow& row);
};

/// All columns in the order in which they are written.
std::span<const FrameColumn> frame_columns();

/// The table of one leaf folder: a header and a line per image.
std::string frames_csv(const std::vector<Frame>& frames);

/// The part of one image. Throws std::runtime_error, file, line and column first, for any other word.
Part image_part(const CsvCell& cell);

/// Reads a frames.csv whose columns may stand in any order. Throws std::runtime_error with one line: file,
/// line and column first.
std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file);

}  // namespace cps
