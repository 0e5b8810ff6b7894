#include "dataset/job/frames.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "numbers/angles.h"

namespace cps {
namespace {

std::string csv_text(const std::string& value) {
  return csv_field(value);
}
std::string csv_text(double value) {
  return fmt::format("{}", value);
}
std::string csv_text(std::int64_t value) {
  return fmt::format("{}", value);
}
std::string csv_text(Part value) {
  return to_string(value);
}

void read_cell(const CsvCell& cell, std::string& value) {
  value = cell.text();
}
void read_cell(const CsvCell& cell, double& value) {
  value = cell.number();
}
void read_cell(const CsvCell& cell, std::int64_t& value) {
  value = cell.whole_number();
  if (value < 0) cell.fail("must not be negative");
}
void read_cell(const CsvCell& cell, Part& value) {
  value = image_part(cell);
}

enum class Source { plan, image };

/// A column that shows a member of the row as it is. Member maps a row to a pointer to the member.
template <typename Member>
constexpr FrameColumn column(const char* name, Source source, Member) {
  return {name, source == Source::plan, [](const FrameRow& row) { return csv_text(*Member{}(row)); },
          [](const CsvCell& cell, FrameRow& row) { read_cell(cell, *Member{}(row)); }};
}

/// A column in degrees of a member in radians.
template <typename Member>
constexpr FrameColumn degrees_column(const char* name, Source source, Member) {
  return {name, source == Source::plan, [](const FrameRow& row) { return csv_text(degrees(*Member{}(row))); },
          [](const CsvCell& cell, FrameRow& row) { *Member{}(row) = radians(cell.number()); }};
}

constexpr std::array columns = {
    column("file", Source::plan, [](auto& row) { return &row.file; }),
    column("part", Source::plan, [](auto& row) { return &row.part; }),
    column("condition", Source::plan, [](auto& row) { return &row.condition; }),
    column("street", Source::plan, [](auto& row) { return &row.street; }),
    column("vehicle_x_m", Source::plan, [](auto& row) { return &row.vehicle.position.x(); }),
    column("vehicle_y_m", Source::plan, [](auto& row) { return &row.vehicle.position.y(); }),
    column("vehicle_z_m", Source::plan, [](auto& row) { return &row.vehicle.position.z(); }),
    degrees_column("vehicle_heading_deg", Source::plan, [](auto& row) { return &row.vehicle.heading_rad; }),
    degrees_column("vehicle_pitch_deg", Source::plan, [](auto& row) { return &row.vehicle.pitch_rad; }),
    degrees_column("vehicle_roll_deg", Source::plan, [](auto& row) { return &row.vehicle.roll_rad; }),
    column("camera_x_m", Source::plan, [](auto& row) { return &row.camera_position.x(); }),
    column("camera_y_m", Source::plan, [](auto& row) { return &row.camera_position.y(); }),
    column("camera_z_m", Source::plan, [](auto& row) { return &row.camera_position.z(); }),
    column("camera_qw", Source::plan, [](auto& row) { return &row.camera_rotation.coeffs().w(); }),
    column("camera_qx", Source::plan, [](auto& row) { return &row.camera_rotation.coeffs().x(); }),
    column("camera_qy", Source::plan, [](auto& row) { return &row.camera_rotation.coeffs().y(); }),
    column("camera_qz", Source::plan, [](auto& row) { return &row.camera_rotation.coeffs().z(); }),
    column("exposure", Source::image, [](auto& row) { return &row.exposure; }),
    column("exposure_bias_ev", Source::image, [](auto& row) { return &row.sensor.exposure_bias_ev; }),
    column("full_well_e", Source::image, [](auto& row) { return &row.sensor.full_well_e; }),
    column("read_noise_e", Source::image, [](auto& row) { return &row.sensor.read_noise_e; }),
    column("sha256", Source::image, [](auto& row) { return &row.sha256; }),
};

}  // namespace

Part image_part(const CsvCell& cell) {
  for (Part part : {Part::train, Part::val, Part::test})
    if (cell.text() == to_string(part)) return part;
  cell.fail("'" + cell.text() + "' is none of train, val, test");
}

Eigen::Isometry3d world_from_camera(const FrameRow& row) {
  return Eigen::Translation3d(row.camera_position) * row.camera_rotation.normalized();
}

FrameRow frame_row(const Frame& frame) {
  const PlannedView& view = *frame.view;
  const Eigen::Isometry3d camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera);
  return {.file = std::filesystem::path(frame.image->file).filename().string(),
          .part = view.part,
          .condition = view.condition,
          .street = view.street,
          .vehicle = view.place,
          .camera_position = camera.translation(),
          .camera_rotation = Eigen::Quaterniond(camera.linear()),
          .exposure = frame.record->exposure,
          .sensor = frame.image->sensor,
          .sha256 = frame.image->sha256};
}

std::span<const FrameColumn> frame_columns() {
  return columns;
}

std::string frames_csv(const std::vector<Frame>& frames) {
  std::string csv;
  for (const FrameColumn& column : columns) {
    if (!csv.empty()) csv += ',';
    csv += column.name;
  }
  for (const Frame& frame : frames) {
    const FrameRow row = frame_row(frame);
    char separator = '\n';
    for (const FrameColumn& column : columns) {
      csv += separator;
      csv += column.write(row);
      separator = ',';
    }
  }
  return csv + '\n';
}

std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  std::vector<FrameRow> rows(table.rows.size());
  for (const FrameColumn& column : columns) {
    const std::size_t c = table.column(column.name);
    for (std::size_t r = 0; r < rows.size(); ++r) column.read(table.at(r, c), rows[r]);
  }
  return rows;
}

}  // namespace cps
