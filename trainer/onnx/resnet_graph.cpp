#include "trainer/onnx/resnet_graph.h"

#include "trainer/network/edges.h"
#include "trainer/network/tensor_batch.h"

namespace cps {
namespace {

std::string add_tensor(OnnxGraph& graph, const std::string& name, const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().to(torch::kCPU, torch::kFloat).contiguous();
  const float* first = flat.data_ptr<float>();
  return add_constant(graph, name, flat.sizes().vec(), std::vector<float>(first, first + flat.numel()));
}

/// (value − mean) / deviation, each in the given shape.
template <std::size_t Count>
std::string add_normalisation(OnnxGraph& graph, const std::string& value, std::vector<std::int64_t> shape,
                              const std::array<double, Count>& mean,
                              const std::array<double, Count>& deviation) {
  const auto constant = [&](const char* name, const std::array<double, Count>& numbers) {
    return add_constant(graph, value + name, shape, std::vector<float>(numbers.begin(), numbers.end()));
  };
  const std::string centred = add_node(graph, "Sub", {value, constant(".mean", mean)}, value + ".centred");
  return add_node(graph, "Div", {centred, constant(".deviation", deviation)}, value + ".normalised");
}

/// Layers by the names of their modules.
struct Layers {
  OnnxGraph& graph;
  const NamedTensors& weights;

  std::string weight(const std::string& name) { return add_tensor(graph, name, weights.at(name)); }

  std::string convolution(const std::string& module, const std::string& x, int stride) {
    const std::int64_t kernel = weights.at(module + ".weight").size(2), pad = kernel / 2;
    return add_node(graph, "Conv", {x, weight(module + ".weight")}, module,
                    {{"kernel_shape", std::vector{kernel, kernel}},
                     {"pads", std::vector{pad, pad, pad, pad}},
                     {"strides", std::vector<std::int64_t>{stride, stride}}});
  }

  std::string batch_norm(const std::string& module, const std::string& x) {
    return add_node(graph, "BatchNormalization",
                    {x, weight(module + ".weight"), weight(module + ".bias"),
                     weight(module + ".running_mean"), weight(module + ".running_var")},
                    module, {{"epsilon", 1e-5f}});  // BatchNorm2d's
  }

  std::string relu(const std::string& name, const std::string& x) {
    return add_node(graph, "Relu", {x}, name);
  }

  std::string block(const std::string& module, const std::string& x, int stride, bool bottleneck) {
    const int convolutions = bottleneck ? 3 : 2, strided = bottleneck ? 2 : 1;
    std::string residual = x, shortcut = x;
    for (int i = 1; i <= convolutions; ++i) {
      const std::string number = std::to_string(i);
      residual = batch_norm(module + ".bn" + number,
                            convolution(module + ".conv" + number, residual, i == strided ? stride : 1));
      if (i < convolutions) residual = relu(module + ".relu" + number, residual);
    }
    if (weights.contains(module + ".downsample.0.weight"))
      shortcut = batch_norm(module + ".downsample.1", convolution(module + ".downsample.0", x, stride));
    return relu(module, add_node(graph, "Add", {residual, shortcut}, module + ".sum"));
  }
};

}  // namespace

std::string add_input_layers(OnnxGraph& graph, const std::string& image, const PixelStatistics& pixels,
                             bool edge_channel) {
  const std::string centred =
      add_node(graph, "Sub", {image, add_scalar(graph, "pixel_mean", pixels.mean)}, "centred_image");
  std::string input = add_node(
      graph, "Mul", {centred, add_scalar(graph, "pixel_scale", 1 / pixels.deviation)}, "normalised_image");
  if (!edge_channel) return input;
  const std::vector<std::int64_t> one_pixel{0, 0, 1, 1, 0, 0, 1, 1};  // before and after N, C, H, W
  const std::string padded =
      add_node(graph, "Pad", {input, add_constant(graph, "edges.pads", {8}, one_pixel)}, "edges.padded",
               {{"mode", std::string("edge")}});
  const std::string gradient =
      add_node(graph, "Conv", {padded, add_tensor(graph, "edges.kernels", sobel_kernels())}, "edges.gradient",
               {{"kernel_shape", std::vector<std::int64_t>{3, 3}}});
  const std::string squares = add_node(graph, "Mul", {gradient, gradient}, "edges.squares");
  const std::string channels = add_constant(graph, "edges.axes", {1}, std::vector<std::int64_t>{1});
  const std::string edges = add_node(
      graph, "Sqrt",
      {add_node(graph, "ReduceSum", {squares, channels}, "edges.sum", {{"keepdims", std::int64_t{1}}})},
      "edges");
  return add_node(graph, "Concat", {input, edges}, "image_and_edges", {{"axis", std::int64_t{1}}});
}

OrientationInputs add_orientation_layers(OnnxGraph& graph, const std::string& tilt,
                                         const std::string& confidence, const std::string& fit,
                                         const OrientationStatistics& by) {
  const std::string weighted = add_node(graph, "Mul", {tilt, confidence}, "edge_tilt.weighted");
  const std::string planes =
      add_node(graph, "Concat", {weighted, confidence}, "edge_planes", {{"axis", std::int64_t{1}}});
  return {
      add_normalisation(graph, planes, {1, orientation_plane_count, 1, 1}, by.plane_mean, by.plane_deviation),
      add_normalisation(graph, fit, {orientation_number_count}, by.number_mean, by.number_deviation)};
}

std::string add_resnet(OnnxGraph& graph, const std::string& input, const std::string& size,
                       const OrientationInputs& orientation, const Architecture& architecture,
                       const NetworkOptions& options, const NamedTensors& weights) {
  Layers layers{graph, weights};
  std::string x = layers.convolution("conv1", input, 2);
  if (options.orientation)
    x = add_node(graph, "Add", {x, layers.convolution("orientation", orientation.planes, 1)},
                 "conv1_and_orientation");
  x = layers.relu("relu", layers.batch_norm("bn1", x));
  if (architecture.max_pool)
    x = add_node(graph, "MaxPool", {x}, "maxpool",
                 {{"kernel_shape", std::vector<std::int64_t>{3, 3}},
                  {"pads", std::vector<std::int64_t>{1, 1, 1, 1}},
                  {"strides", std::vector<std::int64_t>{2, 2}}});
  for (int i = 0; i < 4; ++i)
    for (int b = 0; b < architecture.blocks[i]; ++b)
      x = layers.block("layer" + std::to_string(i + 1) + "." + std::to_string(b), x, b == 0 && i > 0 ? 2 : 1,
                       architecture.bottleneck);
  x = add_node(graph, "Flatten", {add_node(graph, "GlobalAveragePool", {x}, "avgpool")}, "features",
               {{"axis", std::int64_t{1}}});
  if (options.size_features) {
    const std::string unit =
        add_constant(graph, "size_unit", {2}, std::vector{float{size_unit.height}, float{size_unit.width}});
    x = add_node(graph, "Concat", {x, add_node(graph, "Div", {size, unit}, "size_features")},
                 "features_and_size", {{"axis", std::int64_t{1}}});
  }
  if (options.orientation)
    x = add_node(graph, "Concat", {x, orientation.numbers}, "features_and_orientation",
                 {{"axis", std::int64_t{1}}});
  return add_node(graph, "Gemm", {x, layers.weight("fc.weight"), layers.weight("fc.bias")}, "fc",
                  {{"transB", std::int64_t{1}}});
}

}  // namespace cps
