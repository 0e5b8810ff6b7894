#include "dataset/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "dataset/files.h"
#include "distortion/pinhole.h"

namespace cps {
namespace {

/// A field as RFC 4180 has it: quoted only when it must be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

}  // namespace

std::string frames_csv(const std::vector<Frame>& frames) {
  std::string csv =
      "file,part,condition,street,vehicle_x_m,vehicle_y_m,vehicle_z_m,vehicle_heading_deg,vehicle_pitch_deg,"
      "vehicle_roll_deg,"
      "camera_x_m,camera_y_m,camera_z_m,camera_qw,camera_qx,camera_qy,camera_qz,"
      "exposure,exposure_bias_ev,full_well_e,read_noise_e,sha256\n";
  for (const Frame& frame : frames) {
    const PlannedView& view = *frame.view;
    const SensorSettings& sensor = frame.image->sensor;
    const Eigen::Isometry3d camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera);
    const Eigen::Vector3d& vehicle = view.place.position;
    const Eigen::Quaterniond q(camera.linear());
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       std::filesystem::path(frame.image->file).filename().string(), to_string(view.part),
                       view.condition, csv_field(view.street), vehicle.x(), vehicle.y(), vehicle.z(),
                       degrees(view.place.heading_rad), degrees(view.place.pitch_rad),
                       degrees(view.place.roll_rad), camera.translation().x(), camera.translation().y(),
                       camera.translation().z(), q.w(), q.x(), q.y(), q.z(), frame.record->exposure,
                       sensor.exposure_bias_ev, sensor.full_well_e, sensor.read_noise_e, frame.image->sha256);
  }
  return csv;
}

std::vector<FrameRow> read_frames_csv(const std::filesystem::path& file) {
  std::istringstream lines(read_file(file));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = csv_fields(line);
  const auto column = [&](const char* name) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) throw std::runtime_error(file.string() + ": " + name + ": column is missing");
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t name = column("file"), part = column("part"), condition = column("condition"),
                    street = column("street"), hash = column("sha256"), exposure = column("exposure"),
                    bias = column("exposure_bias_ev");
  std::vector<FrameRow> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    if (fields.size() != header.size())
      throw std::runtime_error(file.string() + ": line " + std::to_string(rows.size() + 2) + ": has " +
                               std::to_string(fields.size()) + " fields, its header " +
                               std::to_string(header.size()));
    rows.push_back({fields[name], fields[part], fields[condition], fields[street], fields[hash],
                    std::strtod(fields[exposure].c_str(), nullptr),
                    std::strtod(fields[bias].c_str(), nullptr)});
  }
  return rows;
}

}  // namespace cps
