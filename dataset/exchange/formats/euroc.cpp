#include "dataset/exchange/formats/formats.h"

/// EuRoC's sensor.yaml, one camera: intrinsics fu fv cu cv, radial-tangential k1 k2 p1 p2.
namespace cps {

CalibratedCamera read_euroc(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {});
  const auto list = [&](const std::string& key) { return root.file + ": " + key; };
  const std::vector<double> size = number_list(root.at("resolution"), 2, list("resolution")),
                            focal = number_list(root.at("intrinsics"), 4, list("intrinsics"));
  return {name,
          {.width = size_px(size[0], list("resolution")),
           .height = size_px(size[1], list("resolution")),
           .fx = focal[0],
           .fy = focal[1],
           .cx = focal[2],
           .cy = focal[3]},
          from_opencv_order(number_list(root.at("distortion_coefficients"), list("distortion_coefficients")),
                            list("distortion_coefficients"))};
}

}  // namespace cps
