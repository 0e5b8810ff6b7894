#include <fmt/format.h>

#include <stdexcept>

#include "dataset/exchange/formats.h"

/// Kalibr's camchain YAML, pinhole cameras with radtan distortion: k1 k2 p1 p2.
namespace cps {

Cameras read_kalibr(const JsonKeys& root) {
  Cameras cameras;
  for (const auto& [name, value] : root.json.items()) {
    const std::string where = root.file + ": " + name;
    const JsonKeys keys{value, where};
    if (keys.text("camera_model") != "pinhole")
      keys.fail("camera_model", "is " + keys.text("camera_model") + "; only pinhole is supported");
    const std::string model = keys.text("distortion_model");
    if (model != "radtan" && model != "none")
      keys.fail("distortion_model", "is " + model + "; only radtan is supported");
    const std::vector<double> focal = keys.numbers("intrinsics", 4), size = keys.numbers("resolution", 2);
    Distortion lens;
    if (model == "radtan")
      lens = from_opencv_order(keys.numbers("distortion_coeffs", 4), where + ": distortion_coeffs");
    if (!(size[0] >= 1 && size[0] <= 1 << 20 && size[1] >= 1 && size[1] <= 1 << 20))
      keys.fail("resolution", "must be two sizes in pixels");
    cameras.push_back({name,
                       {.width = static_cast<int>(size[0]),
                        .height = static_cast<int>(size[1]),
                        .fx = focal[0],
                        .fy = focal[1],
                        .cx = focal[2],
                        .cy = focal[3]},
                       lens});
  }
  return cameras;
}

std::string write_kalibr(CameraSpan cameras) {
  std::string text;
  int index = 0;
  for (const CalibratedCamera& camera : cameras) {
    const Pinhole& pinhole = camera.pinhole;
    const Distortion& lens = camera.distortion;
    if (lens.k3 != 0)
      throw std::runtime_error(camera.name + ": k3 is not 0, which Kalibr's radtan has no place for");
    // Kalibr requires these names.
    text += fmt::format("cam{}:\n  camera_model: pinhole\n  distortion_coeffs: [{}]\n", index++,
                        decimals(std::vector{lens.k1, lens.k2, lens.p1, lens.p2}, ", "));
    text += fmt::format("  distortion_model: radtan\n  intrinsics: [{}]\n  resolution: [{}, {}]\n",
                        decimals(std::vector{pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy}, ", "),
                        pinhole.width, pinhole.height);
  }
  return text;
}

}  // namespace cps
