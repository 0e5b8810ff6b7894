#pragma once

#include <string>

#include "trainer/images/orientation/orientation_statistics.h"
#include "trainer/images/pixel_statistics.h"
#include "trainer/network/architectures.h"
#include "trainer/network/resnet.h"
#include "trainer/network/tensor_file.h"
#include "trainer/onnx/onnx_model.h"

namespace cps {

/// Adds the normalisation of pixels that image_tensor() does, and the edge channel if the network has one.
/// `image` is the name of a value [N, 1, H, W], 8-bit pixels. Returns the name of the network's input.
std::string add_input_layers(OnnxGraph& graph, const std::string& image, const PixelStatistics& pixels,
                             bool edge_channel);

/// Names of the values that make up OrientationTensors; empty for a network without orientation.
struct OrientationInputs {
  std::string planes, numbers;
};

/// Adds the products and the normalisation of orientation_tensors(). `tilt` and `confidence` are the names of
/// values [N, 2, H', W'], in natural units, `fit` that of a value [N, 28].
OrientationInputs add_orientation_layers(OnnxGraph& graph, const std::string& tilt,
                                         const std::string& confidence, const std::string& fit,
                                         const OrientationStatistics& statistics);

/// Adds the layers of make_resnet(), with these weights, as they are in evaluation mode. `size` is the name
/// of a value [N, 2], height and width of the original images in pixels. Nodes and constants have the names
/// that modules and weights have. Returns the name of the standardised outputs, [N, 8].
std::string add_resnet(OnnxGraph& graph, const std::string& input, const std::string& size,
                       const OrientationInputs& orientation, const Architecture& architecture,
                       const NetworkOptions& options, const NamedTensors& weights);

}  // namespace cps
