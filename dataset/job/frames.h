#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
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

/// The file of an image's dense label.
struct DenseHash {
  DenseLabel label = DenseLabel::depth;
  std::string sha256;
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
  Eigen::Vector3d gravity = -Eigen::Vector3d::UnitY();  ///< unit vector downwards, in the camera frame
  double exposure = 1;                                  ///< metered
  SensorSettings sensor;
  std::string sha256;                 ///< of the image's file
  std::vector<DenseHash> dense = {};  ///< of the labels that the dataset has, in the enum's order
};

/// The pose of the camera as one transform. The quaternion is normalised.
Eigen::Isometry3d world_from_camera(const FrameRow& row);

/// What FrameRow::gravity must be, by that pose.
Eigen::Vector3d gravity_by_pose(const FrameRow& row);

FrameRow frame_row(const Frame& frame);

/// One column: header, writer, reader, the comparison with a plan and the migration of older tables all go
/// through the table of them.
struct FrameColumn {
  const char* name;
  bool is_planned;  ///< decided by the plan; the other columns are measured or drawn while images are made
  std::string (*write)(const FrameRow& row);
  /// Throws std::runtime_error, file, line and column first.
  void (*read)(const CsvCell& cell, FrameRow& row);
  /// Sets the value in a row of a table without this column, from the columns before it. Null: every table
  /// must have the column.
  void (*derive)(FrameRow& row) = nullptr;
};

/// All columns but those of dense labels, in the order in which they are written.
std::span<const FrameColumn> frame_columns();

/// Where the column stands in the table; nothing where it is missing and can be derived. Throws
/// std::runtime_error with one line, file and column first, where it is missing otherwise.
std::optional<std::size_t> find_column(const CsvTable& table, const FrameColumn& column);

/// The table of one leaf folder: a header and a line per image. The dense labels of the first image are those
/// of all; their columns `<label>_sha256` are the last.
std::string frames_csv(const std::vector<Frame>& frames);

/// The part of one image. Throws std::runtime_error, file, line and column first, for any other word.
Part image_part(const CsvCell& cell);

/// Reads a frames.csv whose columns may stand in any order. Columns of dense labels may be missing, and those
/// that can be derived. Throws std::runtime_error with one line: file, line and column first.
std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file);

}  // namespace cps
