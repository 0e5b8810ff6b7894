#include "dataset/labels/label.h"

#include <cmath>
#include <stdexcept>

#include "dataset/exchange/camera_json.h"
#include "files/json_keys.h"
#include "numbers/angles.h"
#include "scenes/rig.h"

namespace cps {
namespace {

/// Relative. All numbers are written with full precision, so they agree far better than this.
constexpr double agreement = 1e-6;

/// Numbers that are written twice must agree.
void check_camera(const Pinhole& camera, const JsonKeys& reader) {
  if (!(camera.fx > 0 && camera.fy > 0)) reader.fail("K", "focal lengths must be positive");
  const double focal_from_fov = camera.width / (2 * std::tan(radians(reader.number("fov")) / 2));
  if (!(std::abs(camera.fx - focal_from_fov) <= agreement * camera.fx))
    reader.fail("fov", "contradicts K[0][0], which should be width / (2 tan(fov/2))");
  if (!(std::abs(reader.number("cx") - camera.cx) <= agreement * camera.width))
    reader.fail("cx", "contradicts K[0][2]");
  if (!(std::abs(reader.number("cy") - camera.cy) <= agreement * camera.height))
    reader.fail("cy", "contradicts K[1][2]");
}

}  // namespace

Pinhole base_of(const Label& label) {
  return pinhole_from_hfov(label.camera.width, label.camera.height, radians(label.fov_base_deg));
}

Eigen::Vector3d nominal_gravity(const Eigen::Isometry3d& vehicle_from_camera) {
  return gravity_in_camera((world_from_vehicle(Place{}) * vehicle_from_camera).linear());
}

int schema_of(const JsonKeys& keys) {
  const double schema = keys.number("schema");
  if (schema != 1 && schema != 2)
    keys.fail("schema", "is neither 1 nor 2; use the version of cps that wrote it");
  return static_cast<int>(schema);
}

void check_gravity(const JsonKeys& keys, const Eigen::Isometry3d& vehicle_from_camera) {
  const std::vector<double> written = keys.numbers("gravity", 3);
  if (!((Eigen::Vector3d::Map(written.data()) - nominal_gravity(vehicle_from_camera)).norm() <= agreement))
    keys.fail("gravity", "contradicts T_vehicle_camera, whose third row begins with its opposite");
}

Part part_of_label(const JsonKeys& keys) {
  try {
    return part_from_string(keys.text("part"));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(keys.file + ": " + error.what());
  }
}

nlohmann::ordered_json to_json(const Label& label, int schema) {
  nlohmann::ordered_json limits;
  for (std::size_t i = 0; i < lens_keys.size(); ++i) {
    limits[lens_keys[i]] = nullptr;
    if (label.limits[i]) limits[lens_keys[i]] = {label.limits[i]->low, label.limits[i]->high};
  }
  nlohmann::ordered_json json = {{"schema", schema}};
  json.update(camera_json(label.camera, label.distortion));
  json.update(nlohmann::ordered_json{
      {"fov_base_deg", label.fov_base_deg},
      {"fov_true_deg",
       {{"h", label.fov_true_h_deg}, {"v", label.fov_true_v_deg}, {"d", label.fov_true_d_deg}}},
      {"crop", {{"zoom", label.zoom}}},
      {"certificate",
       {{"min_eigenvalue", label.certificate_min_eigenvalue},
        {"max_roundtrip_px", label.certificate_max_roundtrip_px}}},
      {"limits", limits},
      {"camera",
       {{"name", label.rig_camera}, {"T_vehicle_camera", rows_json(label.vehicle_from_camera.matrix())}}}});
  const Eigen::Vector3d gravity = nominal_gravity(label);
  if (schema >= 2) json["gravity"] = {gravity.x(), gravity.y(), gravity.z()};
  json["part"] = to_string(label.part);
  json["seed"] = label.seed;
  json["generator"] = label.generator;
  return json;
}

Label label_from_json(const nlohmann::json& json, const std::string& file) {
  const JsonKeys reader{json, file};
  const int schema = schema_of(reader);
  if (json.contains("params"))
    reader.fail("model", "is " + reader.text("model") +
                             ": only datasets of brown_conrady lenses are read here; cps verify, cps "
                             "contact-sheet and cps eval take this one");
  Label label;
  const CalibratedCamera calibrated = camera_from_json(reader);
  check_camera(calibrated.pinhole, reader);
  label.camera = calibrated.pinhole;
  label.distortion = calibrated.distortion;
  label.fov_base_deg = reader.number("fov_base_deg");
  const JsonKeys true_angles = reader.object("fov_true_deg");
  label.fov_true_h_deg = true_angles.number("h");
  label.fov_true_v_deg = true_angles.number("v");
  label.fov_true_d_deg = true_angles.number("d");
  label.zoom = reader.object("crop").number("zoom");
  const JsonKeys certificate = reader.object("certificate");
  label.certificate_min_eigenvalue = certificate.number("min_eigenvalue");
  label.certificate_max_roundtrip_px = certificate.number("max_roundtrip_px");
  const JsonKeys limits = reader.object("limits");
  for (std::size_t i = 0; i < lens_keys.size(); ++i) {
    if (limits.at(lens_keys[i]).is_null()) continue;
    const std::vector<double> ends = limits.numbers(lens_keys[i], 2);
    label.limits[i] = Interval{.low = ends[0], .high = ends[1]};
  }
  const JsonKeys camera = reader.object("camera");
  label.rig_camera = camera.text("name");
  label.vehicle_from_camera.matrix() = camera.matrix("T_vehicle_camera", 4, 4);
  if (schema >= 2) check_gravity(reader, label.vehicle_from_camera);
  label.part = part_of_label(reader);
  label.seed = reader.unsigned_integer("seed");
  label.generator = reader.text("generator");
  return label;
}

}  // namespace cps
