#include "dataset/labels/model_label.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "dataset/exchange/camera_json.h"
#include "dataset/labels/group_label.h"
#include "dataset/labels/valid_mask.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/proved_camera.h"
#include "distortion/warp/warp_options.h"
#include "files/json_keys.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr int bound_samples = 24;  ///< per axis of the frame

/// Worst distance between a pixel and where the ray that it sees is projected to. A pixel without a ray
/// counts as infinitely far off where the whole frame is proved, and not at all elsewhere.
double roundtrip_px(const ModelCamera& camera, const ModelCertificate& proof) {
  double worst = 0;
  for (int j = 0; j <= bound_samples; ++j)
    for (int i = 0; i <= bound_samples; ++i) {
      const Eigen::Vector2d pixel(-0.5 + camera.pinhole.width * (static_cast<double>(i) / bound_samples),
                                  -0.5 + camera.pinhole.height * (static_cast<double>(j) / bound_samples));
      const auto ray = unproject(camera.lens, proof.region, to_plane(camera.pinhole, pixel));
      if (!ray && proof.valid) return std::numeric_limits<double>::infinity();
      if (!ray) continue;
      worst = std::max(worst, (to_pixel(camera.pinhole, project(camera.lens, *ray).point) - pixel).norm());
    }
  return worst;
}

ModelLabel proved_label(const ModelCamera& camera, const ModelCertificate& proof) {
  return {.camera = camera,
          .seen = seen_angles(camera, proof.region),
          .certificate_min_scale = proof.min_scale,
          .certificate_max_roundtrip_px = roundtrip_px(camera, proof),
          .max_angle_rad = proof.region.max_angle_rad,
          .generator = generator_name()};
}

nlohmann::ordered_json angle_json(const std::optional<double>& angle_rad) {
  return angle_rad ? nlohmann::ordered_json(degrees(*angle_rad)) : nlohmann::ordered_json(nullptr);
}

std::optional<double> angle_from_json(const JsonKeys& keys, const char* key) {
  if (keys.at(key).is_null()) return std::nullopt;
  return radians(keys.number(key));
}

}  // namespace

ModelLabel model_label(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (!proof.valid) throw std::runtime_error("lens is not certified: " + proof.why);
  ModelLabel label = proved_label(camera, proof);
  if (!label.seen.horizontal_rad || !label.seen.vertical_rad || !label.seen.diagonal_rad)
    throw std::runtime_error("lens shows less than its frame: its true angles are not defined");
  return label;
}

ModelLabel masked_model_label(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (is_empty(proof.region)) throw std::runtime_error("lens is not certified: " + proof.why);
  ModelLabel label = proved_label(camera, proof);
  label.valid = valid_mask_file;
  return label;
}

nlohmann::ordered_json to_json(const ModelLabel& label) {
  nlohmann::ordered_json json = {{"schema", label_schema}};
  json.update(model_camera_json(label.camera.pinhole, label.camera.lens));
  json.update(nlohmann::ordered_json{
      {"fov_true_deg",
       {{"h", angle_json(label.seen.horizontal_rad)},
        {"v", angle_json(label.seen.vertical_rad)},
        {"d", angle_json(label.seen.diagonal_rad)}}},
      {"certificate",
       {{"min_scale", label.certificate_min_scale},
        {"max_roundtrip_px", label.certificate_max_roundtrip_px}}},
      {"camera",
       {{"name", label.camera.name}, {"T_vehicle_camera", rows_json(label.vehicle_from_camera.matrix())}}}});
  if (!label.valid.empty()) {
    json["certificate"]["max_angle_deg"] = degrees(label.max_angle_rad);
    json["valid"] = label.valid;
  }
  const Eigen::Vector3d gravity = nominal_gravity(label.vehicle_from_camera);
  json["gravity"] = {gravity.x(), gravity.y(), gravity.z()};
  json["part"] = to_string(label.part);
  json["seed"] = label.seed;
  json["generator"] = label.generator;
  return json;
}

ModelLabel model_label_from_json(const nlohmann::json& json, const std::string& file) {
  const JsonKeys keys{json, file};
  schema_of(keys);
  ModelLabel label{.camera = model_camera_from_json(keys), .seen = {}, .generator = keys.text("generator")};
  const JsonKeys angles = keys.object("fov_true_deg"), certificate = keys.object("certificate"),
                 camera = keys.object("camera");
  label.seen = {.horizontal_rad = angle_from_json(angles, "h"),
                .vertical_rad = angle_from_json(angles, "v"),
                .diagonal_rad = angle_from_json(angles, "d")};
  label.certificate_min_scale = certificate.number("min_scale");
  label.certificate_max_roundtrip_px = certificate.number("max_roundtrip_px");
  if (json.contains("valid")) {
    label.valid = keys.text("valid");
    if (label.valid != valid_mask_file) keys.fail("valid", std::string("must be ") + valid_mask_file);
    label.max_angle_rad = radians(certificate.number("max_angle_deg"));
  }
  label.camera.name = camera.text("name");
  label.vehicle_from_camera.matrix() = camera.matrix("T_vehicle_camera", 4, 4);
  check_gravity(keys, label.vehicle_from_camera);
  label.part = part_of_label(keys);
  label.seed = keys.unsigned_integer("seed");
  return label;
}

Label common_label(const ModelLabel& label) {
  return {.camera = label.camera.pinhole,
          .distortion = {},
          .limits = {},
          .rig_camera = label.camera.name,
          .vehicle_from_camera = label.vehicle_from_camera,
          .part = label.part,
          .seed = label.seed,
          .generator = label.generator};
}

nlohmann::ordered_json other_family_json(const std::string& family) {
  return {{"model", family},
          {"is_cps", false},
          {"note", "Labels have model and params in place of k1 ... p2, so this is not a CPS dataset."}};
}

}  // namespace cps
