#include "dataset/exchange/camera_json.h"
#include "dataset/exchange/formats/formats.h"

/// This project's calibration.json. Only the keys that describe the camera are read, as published CPS
/// datasets have no others.
namespace cps {

CalibratedCamera read_cps(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {"k1", "k2", "k3", "p1", "p2"});
  CalibratedCamera camera = camera_from_json(root);
  const bool is_named = root.json.contains("camera") && root.at("camera").contains("name");
  camera.name = is_named ? name_at(root.object("camera"), "name") : name;
  return camera;
}

std::string write_cps(CameraSpan cameras) {
  const CalibratedCamera& camera = only_camera(cameras);
  nlohmann::ordered_json json = camera_json(camera.pinhole, camera.distortion);
  json["camera"] = {{"name", camera.name}};
  return json.dump(2) + "\n";
}

}  // namespace cps
