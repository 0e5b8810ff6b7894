#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dataset/job/frames.h"
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

/// A part of gravity, which tables of schema 1 lack.
template <int axis>
constexpr FrameColumn gravity_column(const char* name) {
  FrameColumn gravity = column(name, Source::plan, [](auto& row) { return &row.gravity[axis]; });
  gravity.derive = [](FrameRow& row) { row.gravity[axis] = gravity_by_pose(row)[axis]; };
  return gravity;
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
    gravity_column<0>("gravity_x"),
    gravity_column<1>("gravity_y"),
    gravity_column<2>("gravity_z"),
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

std::span<const FrameColumn> frame_columns() {
  return columns;
}

std::optional<std::size_t> find_column(const CsvTable& table, const FrameColumn& column) {
  if (column.derive && std::ranges::find(table.header, column.name) == table.header.end()) return {};
  return table.column(column.name);
}

}  // namespace cps
