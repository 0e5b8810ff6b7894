#include "dataset/job/frames.h"

#include <algorithm>

#include "scenes/rig.h"

namespace cps {
namespace {

std::string dense_column(DenseLabel label) {
  return to_string(label) + "_sha256";
}

void read_dense(const CsvTable& table, std::vector<FrameRow>& rows) {
  for (std::size_t i = 0; i < dense_label_names.size(); ++i) {
    const auto label = static_cast<DenseLabel>(i);
    const auto found = std::ranges::find(table.header, dense_column(label));
    if (found == table.header.end()) continue;
    const auto column = static_cast<std::size_t>(found - table.header.begin());
    for (std::size_t r = 0; r < rows.size(); ++r)
      rows[r].dense.push_back({label, table.at(r, column).text()});
  }
}

}  // namespace

Eigen::Isometry3d world_from_camera(const FrameRow& row) {
  return Eigen::Translation3d(row.camera_position) * row.camera_rotation.normalized();
}

Eigen::Vector3d gravity_by_pose(const FrameRow& row) {
  return gravity_in_camera(world_from_camera(row).linear());
}

FrameRow frame_row(const Frame& frame) {
  const PlannedView& view = *frame.view;
  const Eigen::Isometry3d camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera);
  FrameRow row{.file = std::filesystem::path(frame.image->file).filename().string(),
               .part = view.part,
               .condition = view.condition,
               .street = view.street,
               .vehicle = view.place,
               .camera_position = camera.translation(),
               .camera_rotation = Eigen::Quaterniond(camera.linear()),
               .exposure = frame.record->exposure,
               .sensor = frame.image->sensor,
               .sha256 = frame.image->sha256};
  // Not from `camera`: so an older table, which has only the quaternion, is migrated to the same bytes.
  row.gravity = gravity_by_pose(row);
  for (const DenseRecord& dense : frame.image->dense) row.dense.push_back({dense.label, dense.sha256});
  return row;
}

std::string frames_csv(const std::vector<Frame>& frames) {
  std::string csv;
  for (const FrameColumn& column : frame_columns()) {
    if (!csv.empty()) csv += ',';
    csv += column.name;
  }
  if (!frames.empty())
    for (const DenseRecord& dense : frames.front().image->dense) csv += ',' + dense_column(dense.label);
  for (const Frame& frame : frames) {
    const FrameRow row = frame_row(frame);
    char separator = '\n';
    for (const FrameColumn& column : frame_columns()) {
      csv += separator;
      csv += column.write(row);
      separator = ',';
    }
    for (const DenseHash& dense : row.dense) csv += ',' + dense.sha256;
  }
  return csv + '\n';
}

std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  std::vector<FrameRow> rows(table.rows.size());
  for (const FrameColumn& column : frame_columns()) {
    const std::optional<std::size_t> place = find_column(table, column);
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (place)
        column.read(table.at(r, *place), rows[r]);
      else
        column.derive(rows[r]);
  }
  read_dense(table, rows);
  return rows;
}

}  // namespace cps
