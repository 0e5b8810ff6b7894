#include "dataset/exchange/camera_json.h"
#include "dataset/exchange/formats/formats.h"

/// This project's calibration.json. Only the keys that describe the camera are read, as published CPS
/// datasets have no others.
namespace cps {

ModelCamera read_cps(const JsonKeys& root, const std::string& name) {
  using enum NamedLens;
  const NamedLens named = named_lens(root, {plane, kannala_brandt, unified_spherical, eucm, double_sphere});
  if (named != plane && !root.json.contains("model"))
    root.fail("model", "is missing, though another key names a lens model: give model and params");
  ModelCamera camera = model_camera_from_json(root);
  if (named != plane && std::holds_alternative<Distortion>(camera.lens))
    root.fail("model", "names no other lens model, but another key does: keep one of them");
  const bool is_named = root.json.contains("camera") && root.at("camera").contains("name");
  camera.name = is_named ? name_at(root.object("camera"), "name") : name;
  return camera;
}

std::string write_cps(CameraSpan cameras) {
  const ModelCamera& camera = only_camera(cameras);
  nlohmann::ordered_json json = model_camera_json(camera.pinhole, camera.lens);
  json["camera"] = {{"name", camera.name}};
  return json.dump(2) + "\n";
}

}  // namespace cps
