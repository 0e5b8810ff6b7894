#include <algorithm>
#include <array>

#include "dataset/exchange/formats/formats.h"

/// Nerfstudio's transforms.json, cameras only. Intrinsics stand at the top level, or in a frame, where they
/// override those of the top level. The centre of the top-left pixel is (.5, .5).
namespace cps {
namespace {

constexpr std::array intrinsics{"camera_model", "fl_x", "fl_y", "cx", "cy", "w", "h",
                                "k1",           "k2",   "k3",   "k4", "p1", "p2"};

CalibratedCamera read_one(const JsonKeys& keys, const std::string& name) {
  refuse_other_models(keys, {"k1", "k2", "k3", "p1", "p2"});
  const auto optional = [&](const char* key) { return keys.json.contains(key) ? keys.number(key) : 0.0; };
  const auto pixels = [&](const char* key) { return size_px(keys.number(key), keys.file + ": " + key); };
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

}  // namespace

CalibrationFile read_nerfstudio(const JsonKeys& root, const std::string& name) {
  CalibrationFile file;
  const nlohmann::json frames = root.json.value("frames", nlohmann::json::array());
  nlohmann::json top = root.json;
  top.erase("frames");
  for (const nlohmann::json& frame : frames) {
    const auto overrides = [&](const char* key) { return frame.contains(key); };
    if (!frame.is_object() || std::none_of(intrinsics.begin(), intrinsics.end(), overrides)) continue;
    nlohmann::json merged = top;
    merged.update(frame);
    const std::string path = JsonKeys{frame, root.file}.text("file_path"), where = root.file + ": " + path;
    add_camera(file, path, [&] { return read_one(JsonKeys{merged, where}, path); });
  }
  if (file.cameras.empty() && file.unread.empty())
    file.cameras.push_back(read_one(JsonKeys{top, root.file}, name));
  return file;
}

nlohmann::ordered_json nerfstudio_camera(const CalibratedCamera& camera) {
  const Pinhole& pinhole = camera.pinhole;
  const Distortion& lens = camera.distortion;
  return {{"fl_x", pinhole.fx}, {"fl_y", pinhole.fy},  {"cx", pinhole.cx + 0.5}, {"cy", pinhole.cy + 0.5},
          {"w", pinhole.width}, {"h", pinhole.height}, {"k1", lens.k1},          {"k2", lens.k2},
          {"k3", lens.k3},      {"p1", lens.p1},       {"p2", lens.p2}};
}

std::string write_nerfstudio(CameraSpan cameras) {
  nlohmann::ordered_json json = {{"camera_model", "OPENCV"}};
  if (cameras.size() == 1) json.update(nerfstudio_camera(cameras.front()));
  json["frames"] = nlohmann::ordered_json::array();
  if (cameras.size() > 1)
    for (const CalibratedCamera& camera : cameras) {
      nlohmann::ordered_json frame = {{"file_path", camera.name}};
      frame.update(nerfstudio_camera(camera));
      json["frames"].push_back(frame);
    }
  return json.dump(2) + "\n";
}

}  // namespace cps
