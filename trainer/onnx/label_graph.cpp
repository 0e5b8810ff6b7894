#include "trainer/onnx/label_graph.h"

#include "numbers/angles.h"

namespace cps {
namespace {

std::string add_outputs(OnnxGraph& graph, const std::string& name, const Outputs& outputs) {
  return add_constant(graph, name, {output_count}, std::vector<float>(outputs.begin(), outputs.end()));
}

/// Column `i` of a matrix, [N].
std::string add_column(OnnxGraph& graph, const std::string& matrix, int i, const std::string& name) {
  const std::string index = add_constant(graph, name + ".column", {}, std::vector<std::int64_t>{i});
  return add_node(graph, "Gather", {matrix, index}, name, {{"axis", std::int64_t{1}}});
}

/// The powers of the half diagonal R = tan(fov/2) √(1 + (H/W)²) by which the outputs k1 … p2 were scaled; see
/// TargetSpace::apparent.
std::array<std::string, 5> add_half_diagonals(OnnxGraph& graph, const std::string& fov_rad,
                                              const std::string& height, const std::string& width) {
  const std::string half = add_node(graph, "Mul", {fov_rad, add_scalar(graph, "half", .5)}, "half_fov");
  const std::string slope = add_node(graph, "Tan", {half}, "tan_half_fov");
  const std::string aspect = add_node(graph, "Div", {height, width}, "aspect");
  const std::string square = add_node(graph, "Mul", {aspect, aspect}, "aspect_squared");
  const std::string sum = add_node(graph, "Add", {square, add_scalar(graph, "one", 1)}, "diagonal_squared");
  const std::string diagonal = add_node(graph, "Sqrt", {sum}, "diagonal");
  const std::string r = add_node(graph, "Mul", {slope, diagonal}, "r");
  const std::string r2 = add_node(graph, "Mul", {r, r}, "r2");
  const std::string r4 = add_node(graph, "Mul", {r2, r2}, "r4");
  const std::string r6 = add_node(graph, "Mul", {r4, r2}, "r6");
  return {r2, r4, r6, r, r};
}

}  // namespace

const std::array<LabelOutput, output_count> label_outputs{
    {{"deg", "H-FOV, 2 atan(width / (2 focal length)), degrees"},
     {"1", "radial coefficient, of r^2"},
     {"1", "radial coefficient, of r^4"},
     {"1", "radial coefficient, of r^6"},
     {"1", "tangential coefficient, of 2 x y in x"},
     {"1", "tangential coefficient, of r^2 + 2 x^2 in x"},
     {"px", "principal point, from the centre of the original image's left column"},
     {"px", "principal point, from the centre of the original image's top row"}}};

void add_label_outputs(OnnxGraph& graph, const std::string& standardised, const std::string& size,
                       const Standardisation& by, TargetSpace space) {
  const std::string scaled = add_node(
      graph, "Mul", {standardised, add_outputs(graph, "target_deviation", by.deviation)}, "scaled_targets");
  const std::string targets =
      add_node(graph, "Add", {scaled, add_outputs(graph, "target_mean", by.mean)}, "targets");
  const std::string height = add_column(graph, size, 0, "height"),
                    width = add_column(graph, size, 1, "width");
  const std::string fov_rad = add_column(graph, targets, 0, "fov_rad");
  add_node(graph, "Mul", {fov_rad, add_scalar(graph, "degrees_per_radian", degrees(1))}, "fov");
  if (space == TargetSpace::raw) {
    for (int i = 1; i <= 5; ++i) add_column(graph, targets, i, output_names[i]);
  } else {
    const std::array<std::string, 5> scales = add_half_diagonals(graph, fov_rad, height, width);
    for (int i = 1; i <= 5; ++i) {
      const std::string apparent = add_column(graph, targets, i, std::string("apparent_") + output_names[i]);
      add_node(graph, "Div", {apparent, scales[i - 1]}, output_names[i]);
    }
  }
  add_node(graph, "Mul", {add_column(graph, targets, 6, "cx_per_width"), width}, "cx");
  add_node(graph, "Mul", {add_column(graph, targets, 7, "cy_per_height"), height}, "cy");
  for (int i = 0; i < output_count; ++i)
    graph.outputs.push_back({output_names[i], label_outputs[i].description, {"N"}});
}

}  // namespace cps
