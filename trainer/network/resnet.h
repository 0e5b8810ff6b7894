#pragma once

#include <torch/nn/module.h>
#include <torch/types.h>

#include <memory>

#include "trainer/network/architectures.h"

namespace cps {

/// A network that says eight numbers about each gray image.
struct Network : torch::nn::Module {
  /// images: [n, 1, h, w], normalised. sizes: [n, 2], the *original* images' (height/2160, width/3840), which
  /// tell a reduced image from a small one. Returns [n, 8], standardised targets.
  virtual torch::Tensor forward(const torch::Tensor& images, const torch::Tensor& sizes) = 0;

  /// Where its weights are, and images must be.
  torch::Device device() const { return parameters().front().device(); }
};

struct NetworkOptions {
  double dropout = 0;         ///< of the features before the last layer
  bool size_features = true;  ///< the two size numbers join the pooled features; else they are not looked at
  bool edge_channel = false;  ///< the first layer sees with_sobel_edges() of the images
};

/// Deep residual network (He, Zhang, Ren, Sun 2016; stride on the 3×3 convolution of a bottleneck, as in
/// torchvision) for one gray channel (and its edges), with one last layer `fc`. Parameters and buffers carry
/// torchvision's names. Initial weights come from torch's generator: seed it first. `fc` starts at zero, so
/// an untrained network says the training mean.
std::shared_ptr<Network> make_resnet(const Architecture& architecture, const NetworkOptions& options);

}  // namespace cps
