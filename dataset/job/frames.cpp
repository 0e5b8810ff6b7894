#include "dataset/job/frames.h"

#include <fmt/format.h>

#include "distortion/pinhole.h"
#include "files/csv.h"
#include "numbers/angles.h"

namespace cps {

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
  const CsvTable table = read_csv(file);
  const std::size_t name = table.column("file"), part = table.column("part"),
                    condition = table.column("condition"), street = table.column("street"),
                    hash = table.column("sha256"), exposure = table.column("exposure"),
                    bias = table.column("exposure_bias_ev");
  std::vector<FrameRow> rows;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const std::vector<std::string>& fields = table.rows[r];
    rows.push_back({fields[name], fields[part], fields[condition], fields[street], fields[hash],
                    table.number(r, exposure), table.number(r, bias)});
  }
  return rows;
}

}  // namespace cps
