#include "dataset/exchange/formats/formats.h"

/// EuRoC's sensor.yaml, one camera: intrinsics fu fv cu cv, radial-tangential k1 k2 p1 p2 or equidistant k1
/// k2 k3 k4.
namespace cps {

ModelCamera read_euroc(const JsonKeys& root, const std::string& name) {
  const NamedLens named = named_lens(root, {NamedLens::plane, NamedLens::kannala_brandt});
  refuse_other_coefficients(root, {});
  const auto list = [&](const std::string& key) { return root.file + ": " + key; };
  const std::vector<double> size = number_list(root.at("resolution"), 2, list("resolution")),
                            focal = number_list(root.at("intrinsics"), 4, list("intrinsics")),
                            coefficients = number_list(root.at("distortion_coefficients"),
                                                       list("distortion_coefficients"));
  ModelCamera camera{name,
                     {.width = size_px(size[0], list("resolution")),
                      .height = size_px(size[1], list("resolution")),
                      .fx = focal[0],
                      .fy = focal[1],
                      .cx = focal[2],
                      .cy = focal[3]},
                     {}};
  if (named == NamedLens::kannala_brandt)
    camera.lens = kannala_brandt_lens(coefficients, list("distortion_coefficients"));
  else
    camera.lens = brown_conrady_lens(coefficients, list("distortion_coefficients"));
  return camera;
}

}  // namespace cps
