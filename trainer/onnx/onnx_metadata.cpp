#include "trainer/onnx/onnx_metadata.h"

#include <fmt/format.h>

#include "trainer/onnx/label_graph.h"

namespace cps {
namespace {

std::string size_rule(const Reduction& reduction) {
  const std::string scale = reduction.factor > 0
                                ? fmt::format("1 / {}", reduction.factor)
                                : fmt::format("min(1, {} / original width)", reduction.width);
  return "each side is max(1, round(scale * original side)), halves rounded up; scale = " + scale;
}

void add_orientation(std::vector<std::pair<std::string, std::string>>& metadata,
                     const OrientationOptions& orientation) {
  metadata.insert(
      metadata.end(),
      {{"orientation", "true"},
       {"input_edges",
        fmt::format(
            "inputs edge_tilt, edge_confidence, edge_fit, of the gray picture before reduction (first "
            "area-averaged to width {}, or to the network's image if that is larger, where it is wider): slopes gx, gy by "
            "Scharr's 3x3 operator (3 10 3) at all pixels but the outermost; near-vertical edges where "
            "gx^2 > 16 gy^2, near-horizontal ones where gy^2 > 16 gx^2; a pixel belongs to the cell that holds "
            "its centre, of ceil(W / 2) x ceil(H / 2) equal cells",
            orientation.max_width)},
       {"input_edge_tilt",
        "float32 [N, 2, H2, W2], H2 = ceil(H / 2), W2 = ceil(W / 2): sum(gx gy) / sum(gx^2) over a cell's "
        "near-vertical edges, sum(gx gy) / sum(gy^2) over its near-horizontal ones; 0 where there are none; "
        "rounded to 1 / 508"},
       {"input_edge_confidence",
        "float32 [N, 2, H2, W2]: sqrt(w / (w + m)), w = sum(gx^2) over a cell's near-vertical edges or "
        "sum(gy^2) over its near-horizontal ones, divided by 1 + v / .0009, v = the variance of its tilts, "
        "m = the picture's sum(gx^2 + gy^2) / number of cells; "
        "rounded to 1 / 127"},
       {"input_edge_fit", fmt::format("float32 [N, 28], see docs/formats.md of cps: {}",
                                      fmt::join(orientation_number_names, " "))}});
}

}  // namespace

std::vector<std::pair<std::string, std::string>> onnx_metadata(const ModelCard& card,
                                                               const std::string& weights_sha256) {
  const TrainOptions& options = card.options;
  std::array<const char*, output_count> units;
  for (int i = 0; i < output_count; ++i) units[i] = label_outputs[i].unit;
  std::vector<std::pair<std::string, std::string>> metadata{
      {"input_image",
       "float32 [N, 1, H, W]: gray pixels, 0 black to 255 white; images of one size to a batch"},
      {"input_gray",
       "round(0.2126 R + 0.7152 G + 0.0722 B) of the 8-bit values as stored (sRGB-encoded, not linear light); "
       "alpha is ignored; an image of one channel is gray already"},
      {"input_crop", "none: the whole frame"},
      {"input_size", size_rule(options.reduction)},
      {"input_resampling",
       "area average: each pixel is the mean of the original pixels that it covers, parts of pixels by their "
       "share, rounded to 8 bits"},
      {"input_normalisation",
       fmt::format("in the graph: (pixel - {}) / {}", card.pixels.mean, card.pixels.deviation)},
      {"input_original_size",
       "input `size`, float32 [N, 2]: height and width of the original image in pixels, before reduction"},
      {"output_names", fmt::format("{}", fmt::join(output_names, " "))},
      {"output_units", fmt::format("{}", fmt::join(units, " "))},
      {"output_convention",
       "Brown-Conrady, from ideal (x, y) to distorted, OpenCV's order and signs: "
       "xd = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), "
       "yd = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y; "
       "pixel (f xd + cx, f yd + cy) of the original image, f = width / (2 tan(fov / 2)); "
       "the centre of its top-left pixel is (0, 0)"},
      {"output_learned", fmt::format("{}", fmt::join(options.outputs, " "))},
      {"output_not_in_graph",
       "fov outside 0 to 180 is no camera; a predicted lens need not be one-to-one: cps predict multiplies "
       "k1 k2 k3 p1 p2 by the largest share for which the lens is certified on its frame, and moves the "
       "principal point into the frame"},
      {"target_space", to_string(options.target_space)},
      {"target_mean", fmt::format("{}", fmt::join(card.targets.mean, " "))},
      {"target_deviation", fmt::format("{}", fmt::join(card.targets.deviation, " "))},
      {"architecture", options.architecture},
      {"size_features", options.size_features ? "true" : "false"},
      {"edge_channel", options.edge_channel ? "true" : "false"},
      {"model_card_schema", std::to_string(model_schema)},
      {"model_epoch", std::to_string(card.epoch)},
      {"model_validation_loss", fmt::format("{}", card.validation_loss)},
      {"dataset_hash", card.dataset_hash},
      {"weights_sha256", weights_sha256},
  };
  if (options.orientation.measured) add_orientation(metadata, options.orientation);
  return metadata;
}

}  // namespace cps
