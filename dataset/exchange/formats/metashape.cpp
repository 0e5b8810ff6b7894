#include <stdexcept>

#include "dataset/exchange/formats/formats.h"

/// Agisoft Metashape's <calibration>. Its manual's frame camera: x' = x(1 + k1 r² + k2 r⁴ + k3 r⁶ + k4 r⁸) +
/// p1 (r² + 2x²) + 2 p2 x y, y' likewise with p2 (r² + 2y²) + 2 p1 x y: its p1 is OpenCV's p2 and the other
/// way round. The fisheye (in later versions: equidistant fisheye) camera puts the same on (x, y) of length
/// θ, which without p1, p2 is Kannala and Brandt's. u = width/2 + cx + x' f + x' b1 + y' b2, v = height/2 +
/// cy + y' f, with the centre of the top-left pixel at (.5, .5).
namespace cps {

ModelCamera read_metashape(const JsonKeys& root, const std::string& name) {
  const bool is_fisheye =
      named_lens(root, {NamedLens::plane, NamedLens::kannala_brandt}) == NamedLens::kannala_brandt;
  if (is_fisheye)
    refuse_other_coefficients(root, {"k1", "k2", "k3", "k4", "b1"});
  else
    refuse_other_coefficients(root, {"k1", "k2", "k3", "p1", "p2", "b1"});
  const auto optional = [&](const char* key) { return root.json.contains(key) ? root.number(key) : 0.0; };
  const int width = root.pixels("width"), height = root.pixels("height");
  const double f = root.number("f");
  ModelCamera camera{name,
                     {.width = width,
                      .height = height,
                      .fx = f + optional("b1"),
                      .fy = f,
                      .cx = 0.5 * width + optional("cx") - 0.5,
                      .cy = 0.5 * height + optional("cy") - 0.5},
                     {}};
  if (is_fisheye)
    camera.lens =
        KannalaBrandt{.k1 = optional("k1"), .k2 = optional("k2"), .k3 = optional("k3"), .k4 = optional("k4")};
  else
    camera.lens = Distortion{.k1 = optional("k1"),
                             .k2 = optional("k2"),
                             .k3 = optional("k3"),
                             .p1 = optional("p2"),
                             .p2 = optional("p1")};
  return camera;
}

}  // namespace cps
