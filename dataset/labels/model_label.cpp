#include "dataset/labels/model_label.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "dataset/exchange/camera_json.h"
#include "dataset/labels/group_label.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/warp/warp_options.h"
#include "numbers/angles.h"
#include "scenes/rig.h"

namespace cps {
namespace {

constexpr int bound_samples = 24;  ///< per axis of the frame

/// Worst distance between a pixel and where the ray that it sees is projected to.
double roundtrip_px(const ModelCamera& camera, const RayRegion& region) {
  double worst = 0;
  for (int j = 0; j <= bound_samples; ++j)
    for (int i = 0; i <= bound_samples; ++i) {
      const Eigen::Vector2d pixel(-0.5 + camera.pinhole.width * (static_cast<double>(i) / bound_samples),
                                  -0.5 + camera.pinhole.height * (static_cast<double>(j) / bound_samples));
      const auto ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel));
      if (!ray) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, (to_pixel(camera.pinhole, project(camera.lens, *ray).point) - pixel).norm());
    }
  return worst;
}

}  // namespace

ModelLabel model_label(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (!proof.valid) throw std::runtime_error("lens is not certified: " + proof.why);
  const std::optional<TrueFov> seen = seen_fov(camera, proof.region);
  if (!seen) throw std::runtime_error("lens shows less than its frame: its true angles are not defined");
  return {.camera = camera,
          .seen = *seen,
          .certificate_min_scale = proof.min_scale,
          .certificate_max_roundtrip_px = roundtrip_px(camera, proof.region),
          .generator = generator_name()};
}

nlohmann::ordered_json to_json(const ModelLabel& label) {
  nlohmann::ordered_json json = {{"schema", label_schema}};
  json.update(model_camera_json(label.camera.pinhole, label.camera.lens));
  json.update(nlohmann::ordered_json{
      {"fov_true_deg",
       {{"h", degrees(label.seen.horizontal_rad)},
        {"v", degrees(label.seen.vertical_rad)},
        {"d", degrees(label.seen.diagonal_rad)}}},
      {"certificate",
       {{"min_scale", label.certificate_min_scale},
        {"max_roundtrip_px", label.certificate_max_roundtrip_px}}},
      {"camera",
       {{"name", label.camera.name}, {"T_vehicle_camera", rows_json(label.vehicle_from_camera.matrix())}}}});
  const Eigen::Vector3d gravity =
      gravity_in_camera((world_from_vehicle(Place{}) * label.vehicle_from_camera).linear());
  json["gravity"] = {gravity.x(), gravity.y(), gravity.z()};
  json["part"] = to_string(label.part);
  json["seed"] = label.seed;
  json["generator"] = label.generator;
  return json;
}

}  // namespace cps
