#include "dataset/exchange/formats.h"

/// Nerfstudio's transforms.json, cameras only. Intrinsics stand at the top level, or in a frame, where they
/// override those of the top level. The centre of the top-left pixel is (.5, .5).
namespace cps {
namespace {

CalibratedCamera read_one(const JsonKeys& keys, const std::string& name) {
  if (keys.json.contains("camera_model")) {
    const std::string model = keys.text("camera_model");
    if (model != "OPENCV" && model != "PINHOLE" && model != "SIMPLE_PINHOLE")
      keys.fail("camera_model", "is " + model + "; only OPENCV and PINHOLE are supported");
  }
  const auto optional = [&](const char* key) { return keys.json.contains(key) ? keys.number(key) : 0.0; };
  if (optional("k4") != 0) keys.fail("k4", "is not 0; only k1 k2 k3 p1 p2 are supported");
  const auto pixels = [&](const char* key) {  // some tools write 1920.0
    const double value = keys.number(key);
    if (!(value >= 1 && value <= 1 << 20)) keys.fail(key, "must be a size in pixels");
    return static_cast<int>(value);
  };
  const double fx = keys.number("fl_x");
  return {name,
          {.width = pixels("w"),
           .height = pixels("h"),
           .fx = fx,
           .fy = keys.json.contains("fl_y") ? keys.number("fl_y") : fx,
           .cx = keys.number("cx") - 0.5,
           .cy = keys.number("cy") - 0.5},
          {.k1 = optional("k1"),
           .k2 = optional("k2"),
           .k3 = optional("k3"),
           .p1 = optional("p1"),
           .p2 = optional("p2")}};
}

nlohmann::ordered_json to_json(const CalibratedCamera& camera) {
  const Pinhole& pinhole = camera.pinhole;
  const Distortion& lens = camera.distortion;
  return {{"fl_x", pinhole.fx}, {"fl_y", pinhole.fy},  {"cx", pinhole.cx + 0.5}, {"cy", pinhole.cy + 0.5},
          {"w", pinhole.width}, {"h", pinhole.height}, {"k1", lens.k1},          {"k2", lens.k2},
          {"k3", lens.k3},      {"p1", lens.p1},       {"p2", lens.p2}};
}

}  // namespace

Cameras read_nerfstudio(const JsonKeys& root, const std::string& name) {
  Cameras cameras;
  if (root.json.contains("frames"))
    for (const nlohmann::json& frame : root.at("frames")) {
      if (!frame.is_object() || !frame.contains("fl_x")) continue;
      nlohmann::json merged = root.json;
      merged.update(frame);
      const std::string path = JsonKeys{frame, root.file}.text("file_path"), where = root.file + ": " + path;
      cameras.push_back(read_one(JsonKeys{merged, where}, path));
    }
  if (cameras.empty()) cameras.push_back(read_one(root, name));
  return cameras;
}

std::string write_nerfstudio(CameraSpan cameras) {
  nlohmann::ordered_json json = {{"camera_model", "OPENCV"}};
  if (cameras.size() == 1) json.update(to_json(cameras.front()));
  json["frames"] = nlohmann::ordered_json::array();
  if (cameras.size() > 1)
    for (const CalibratedCamera& camera : cameras) {
      nlohmann::ordered_json frame = {{"file_path", camera.name}};
      frame.update(to_json(camera));
      json["frames"].push_back(frame);
    }
  return json.dump(2) + "\n";
}

}  // namespace cps
