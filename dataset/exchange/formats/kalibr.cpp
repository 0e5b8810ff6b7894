#include <fmt/format.h>

#include <stdexcept>

#include "dataset/exchange/formats/formats.h"

/// Kalibr's camchain YAML, pinhole cameras with radtan distortion: k1 k2 p1 p2.
namespace cps {

namespace {

CalibratedCamera read_one(const JsonKeys& keys, const std::string& name) {
  if (keys.text("camera_model") != "pinhole")
    keys.fail("camera_model", "is " + keys.text("camera_model") + "; only pinhole is supported");
  const std::string model = keys.text("distortion_model");
  if (model != "radtan" && model != "none")
    keys.fail("distortion_model", "is " + model + "; only radtan is supported");
  refuse_other_models(keys, {"camera_model", "distortion_model"});
  const auto list = [&](const char* key, std::size_t count) {
    return number_list(keys.at(key), count, keys.file + ": " + key);
  };
  const std::vector<double> focal = list("intrinsics", 4), size = list("resolution", 2);
  Distortion lens;
  if (model == "radtan")
    lens = from_opencv_order(list("distortion_coeffs", 4), keys.file + ": distortion_coeffs");
  const std::string where = keys.file + ": resolution";
  return {name,
          {.width = size_px(size[0], where),
           .height = size_px(size[1], where),
           .fx = focal[0],
           .fy = focal[1],
           .cx = focal[2],
           .cy = focal[3]},
          lens};
}

}  // namespace

CalibrationFile read_kalibr(const JsonKeys& root) {
  CalibrationFile file;
  for (const auto& [name, value] : root.json.items()) {
    if (!value.is_object()) continue;  // notes beside the cameras
    const std::string where = root.file + ": " + name;
    add_camera(file, name, [&] { return read_one(JsonKeys{value, where}, name); });
  }
  return file;
}

std::string write_kalibr(CameraSpan cameras) {
  std::string text;
  int index = 0;
  for (const CalibratedCamera& camera : cameras) {
    const Pinhole& pinhole = camera.pinhole;
    const Distortion& lens = camera.distortion;
    if (lens.k3 != 0)
      throw std::runtime_error(camera.name + ": k3 is not 0, which Kalibr's radtan has no place for");
    // Kalibr looks for cam0, cam1, …
    text += fmt::format("cam{}:\n  camera_model: pinhole\n  distortion_coeffs: [{}]\n", index++,
                        decimals(std::vector{lens.k1, lens.k2, lens.p1, lens.p2}, ", "));
    text += fmt::format("  distortion_model: radtan\n  intrinsics: [{}]\n  resolution: [{}, {}]\n",
                        decimals(std::vector{pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy}, ", "),
                        pinhole.width, pinhole.height);
  }
  return text;
}

}  // namespace cps
