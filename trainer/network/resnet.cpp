#include "trainer/network/resnet.h"

#include <ATen/ATen.h>
#include <torch/nn/init.h>
#include <torch/nn/modules/batchnorm.h>
#include <torch/nn/modules/container/sequential.h>
#include <torch/nn/modules/conv.h>
#include <torch/nn/modules/linear.h>

#include "trainer/calibration/targets.h"
#include "trainer/network/autocast.h"
#include "trainer/network/edges.h"

namespace cps {
namespace {

namespace nn = torch::nn;
using torch::Tensor;

nn::Conv2d convolution(int in, int out, int kernel, int stride) {
  return nn::Conv2d(nn::Conv2dOptions(in, out, kernel).stride(stride).padding(kernel / 2).bias(false));
}

/// The layers of a shortcut whose block changes the shape; empty if it does not.
nn::Sequential projection(int in, int out, int stride) {
  if (stride == 1 && in == out) return nullptr;
  return nn::Sequential(convolution(in, out, 1, stride), nn::BatchNorm2d(out));
}

struct BasicBlock final : nn::Module {
  static constexpr int expansion = 1;
  nn::Conv2d conv1, conv2;
  nn::BatchNorm2d bn1, bn2;
  nn::Sequential downsample;

  BasicBlock(int in, int channels, int stride)
      : conv1(convolution(in, channels, 3, stride)),
        conv2(convolution(channels, channels, 3, 1)),
        bn1(channels),
        bn2(channels),
        downsample(projection(in, channels, stride)) {
    register_module("conv1", conv1);
    register_module("bn1", bn1);
    register_module("conv2", conv2);
    register_module("bn2", bn2);
    if (downsample) register_module("downsample", downsample);
    nn::init::zeros_(bn2->weight);  // each block starts as the identity (Goyal et al. 2017)
  }

  Tensor forward(const Tensor& x) {
    const Tensor residual = bn2(conv2(bn1(conv1(x)).relu_()));
    return residual.add_(downsample ? downsample->forward(x) : x).relu_();
  }
};

struct Bottleneck final : nn::Module {
  static constexpr int expansion = 4;
  nn::Conv2d conv1, conv2, conv3;
  nn::BatchNorm2d bn1, bn2, bn3;
  nn::Sequential downsample;

  Bottleneck(int in, int channels, int stride)
      : conv1(convolution(in, channels, 1, 1)),
        conv2(convolution(channels, channels, 3, stride)),
        conv3(convolution(channels, expansion * channels, 1, 1)),
        bn1(channels),
        bn2(channels),
        bn3(expansion * channels),
        downsample(projection(in, expansion * channels, stride)) {
    register_module("conv1", conv1);
    register_module("bn1", bn1);
    register_module("conv2", conv2);
    register_module("bn2", bn2);
    register_module("conv3", conv3);
    register_module("bn3", bn3);
    if (downsample) register_module("downsample", downsample);
    nn::init::zeros_(bn3->weight);
  }

  Tensor forward(const Tensor& x) {
    const Tensor residual = bn3(conv3(torch::relu(bn2(conv2(bn1(conv1(x)).relu_())))));
    return residual.add_(downsample ? downsample->forward(x) : x).relu_();
  }
};

/// The stages whose feature maps weigh the edges.
constexpr std::array<int, 3> weighed_stages{0, 1, 3};

template <typename Block>
struct ResNet final : Network {
  nn::Conv2d conv1;
  nn::BatchNorm2d bn1;
  nn::Conv2d orientation{nullptr};
  std::array<nn::Sequential, 4> layers;
  nn::Linear fc;
  std::array<nn::Conv2d, 3> edge_weights{nullptr, nullptr, nullptr};  // of the maps that are weighed
  bool max_pool;
  NetworkOptions options;

  ResNet(const Architecture& architecture, const NetworkOptions& options)
      : conv1(convolution(options.edge_channel ? 2 : 1, architecture.width, 7, 2)),
        bn1(architecture.width),
        fc(8 * architecture.width * Block::expansion + number_count(options), options.outputs),
        max_pool(architecture.max_pool),
        options(options) {
    register_module("conv1", conv1);
    register_module("bn1", bn1);
    if (options.orientation)
      orientation =
          register_module("orientation", convolution(orientation_plane_count, architecture.width, 3, 1));
    int in = architecture.width;
    for (int i = 0; i < 4; ++i) {
      const int channels = architecture.width << i;
      for (int b = 0; b < architecture.blocks[i]; ++b) {
        layers[i]->push_back(Block(in, channels, b == 0 && i > 0 ? 2 : 1));
        in = channels * Block::expansion;
      }
      register_module("layer" + std::to_string(i + 1), layers[i]);
    }
    register_module("fc", fc);
    if (options.edge_weights)
      for (int i = 0; i < 3; ++i)
        edge_weights[i] = register_module(
            "edge_weights" + std::to_string(weighed_stages[i] + 1),
            nn::Conv2d(nn::Conv2dOptions((architecture.width << weighed_stages[i]) * Block::expansion,
                                         edge_families, 1)));
    for (auto& module : modules(false))
      if (auto* convolution = module->as<nn::Conv2d>())
        nn::init::kaiming_normal_(convolution->weight, 0, torch::kFanOut, torch::kReLU);
    nn::init::zeros_(fc->weight);
    nn::init::zeros_(fc->bias);
    for (nn::Conv2d& weights : edge_weights)
      if (weights) {
        nn::init::zeros_(weights->weight);
        nn::init::zeros_(weights->bias);
      }
  }

  /// Numbers that join the pooled features.
  static int number_count(const NetworkOptions& options) {
    return (options.size_features ? 2 : 0) + (options.orientation ? orientation_number_count : 0);
  }

  /// The feature maps of the four stages, in the training precision.
  std::array<Tensor, 4> feature_maps(const Tensor& input, const Tensor& planes) {
    const Autocast autocast(is_training() ? training_precision : Precision::float32);
    Tensor x = conv1(input);
    if (orientation) x.add_(orientation(planes));  // as large as conv1's result, see orientation_grid()
    x = bn1(x).relu_();
    if (max_pool) x = torch::max_pool2d(x, 3, 2, 1);
    std::array<Tensor, 4> maps;
    for (int i = 0; i < 4; ++i) maps[i] = x = layers[i]->forward(x);
    return maps;
  }

  /// Sum of what each weighed map says, in the first one's size.
  Tensor weigh_edges(const std::array<Tensor, 4>& maps) {
    Tensor sum;
    for (int i = 0; i < 3; ++i) {
      const Tensor part = edge_weights[i](maps[weighed_stages[i]].to(torch::kFloat));
      sum = i == 0 ? part : sum + at::upsample_nearest2d(part, sum.sizes().slice(2));
    }
    return sum;
  }

  NetworkOutput forward(const Tensor& images, const Tensor& sizes, const OrientationTensors& edges) override {
    const std::array<Tensor, 4> maps =
        feature_maps(options.edge_channel ? with_sobel_edges(images) : images, edges.planes);
    // float32 from here: few numbers, and all of them count
    Tensor x = maps.back().to(torch::kFloat).mean({2, 3});
    if (options.size_features) x = torch::cat({x, sizes}, 1);
    if (options.orientation) x = torch::cat({x, edges.numbers}, 1);
    return {fc(torch::dropout(x, options.dropout, is_training())),
            options.edge_weights ? weigh_edges(maps) : Tensor{}};
  }
};

}  // namespace

std::shared_ptr<Network> make_resnet(const Architecture& architecture, const NetworkOptions& options) {
  if (architecture.bottleneck) return std::make_shared<ResNet<Bottleneck>>(architecture, options);
  return std::make_shared<ResNet<BasicBlock>>(architecture, options);
}

}  // namespace cps
