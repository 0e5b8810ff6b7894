#pragma once

#include <torch/nn/module.h>
#include <torch/types.h>

#include <memory>

#include "trainer/network/architectures.h"
#include "trainer/network/orientation_tensors.h"
#include "trainer/network/precision.h"

namespace cps {

/// What a network says of the images of a batch.
struct NetworkOutput {
  torch::Tensor numbers;  ///< [n, outputs] float32: with a brown_conrady head, standardised outputs
  /// [n, 2, h'', w''] float32: logarithms of the weights of near-vertical and of near-horizontal edges, in
  /// weight_grid(); undefined unless NetworkOptions::edge_weights.
  torch::Tensor edge_weights = {};
};

/// A network that predicts some numbers for each gray image.
struct Network : torch::nn::Module {
  /// Of the convolutions in training mode. In evaluation mode all is float32, whatever the network was
  /// trained in, so that a model predicts the same everywhere.
  Precision training_precision = Precision::float32;

  /// images: [n, 1, h, w], normalised. sizes: [n, 2], height/2160 and width/3840 of the *original* images,
  /// which distinguish a reduced image from a small one. orientation: for a network that takes it, else
  /// ignored.
  virtual NetworkOutput forward(const torch::Tensor& images, const torch::Tensor& sizes,
                                const OrientationTensors& orientation = {}) = 0;

  /// The device of its weights, where images must be, too.
  torch::Device device() const { return parameters().front().device(); }
};

struct NetworkOptions {
  double dropout = 0;         ///< of the features before the last layer
  bool size_features = true;  ///< append the two size numbers to the pooled features; otherwise ignore them
  bool edge_channel = false;  ///< feed the first layer with_sobel_edges() of the images
  /// Take the orientation of edges: its planes, through a convolution of their own, are added to the result
  /// of the first one, and its numbers are appended to the pooled features.
  bool orientation = false;
  /// Also weigh the edges, by 1×1 convolutions of the feature maps of the first, second and last stage, the
  /// coarser ones enlarged. Needs orientation, and an architecture with max_pool. All weights start at 1.
  bool edge_weights = false;
  int outputs = 8;  ///< of the last layer: unit_count() of the head
};

/// Builds a deep residual network (He, Zhang, Ren, Sun 2016; with the stride on the 3×3 convolution of a
/// bottleneck, as in torchvision) for one gray channel (and its edges), with one last layer `fc`. Parameters
/// and buffers have torchvision's names; the convolution of the orientation is `orientation`. Initial weights
/// come from torch's global generator: seed it first. `fc` starts at zero, so an untrained network predicts
/// the training mean, or, with a DeepCalib head, the middle of both intervals.
std::shared_ptr<Network> make_resnet(const Architecture& architecture, const NetworkOptions& options);

}  // namespace cps
