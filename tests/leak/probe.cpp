#include "tests/leak/probe.h"

#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cps {
namespace {

constexpr int batch_size = 64;

struct ProbeNetwork : torch::nn::Module {
  torch::nn::Sequential features, head;

  ProbeNetwork() {
    const auto convolution = [](int in, int out, int stride) {
      return torch::nn::Conv2d(torch::nn::Conv2dOptions(in, out, 3).stride(stride).padding(1).bias(false));
    };
    features = torch::nn::Sequential(
        convolution(1, 12, 1), torch::nn::BatchNorm2d(12), torch::nn::ReLU(), convolution(12, 24, 2),
        torch::nn::BatchNorm2d(24), torch::nn::ReLU(), convolution(24, 24, 2), torch::nn::BatchNorm2d(24),
        torch::nn::ReLU(), torch::nn::AdaptiveAvgPool2d(torch::nn::AdaptiveAvgPool2dOptions({6, 8})));
    head = torch::nn::Sequential(torch::nn::Flatten(), torch::nn::Linear(24 * 48, 64), torch::nn::ReLU(),
                                 torch::nn::Linear(64, secret_count));
    register_module("features", features);
    register_module("head", head);
  }
  torch::Tensor forward(const torch::Tensor& images) { return head->forward(features->forward(images)); }
};

/// [n, 1, h, w], 8 bit.
torch::Tensor image_tensor(const WallPictures& pictures) {
  const torch::Tensor bytes =
      torch::from_blob(const_cast<std::uint8_t*>(pictures.pixels.data()),
                       {std::int64_t(pictures.count()), 1, pictures.height, pictures.width}, torch::kUInt8);
  return bytes.clone();
}

/// Each picture about its own mean, in units of eight 8-bit steps.
torch::Tensor normalised(const torch::Tensor& bytes) {
  const torch::Tensor values = bytes.to(torch::kFloat);
  return (values - values.mean({1, 2, 3}, true)) / 8;
}

torch::Tensor secret_tensor(const WallPictures& pictures) {
  torch::Tensor secrets = torch::empty({std::int64_t(pictures.count()), secret_count}, torch::kFloat);
  for (std::size_t i = 0; i < pictures.count(); ++i)
    for (int s = 0; s < secret_count; ++s) secrets[i][s] = float(pictures.secrets[i][s]);
  return secrets;
}

Guess judge(const torch::Tensor& guess, const torch::Tensor& truth) {
  const torch::Tensor x = guess - guess.mean(), y = truth - truth.mean();
  const double spread = std::sqrt((x * x).sum().item<double>() * (y * y).sum().item<double>());
  const double r = spread > 0 ? (x * y).sum().item<double>() / spread : 0;
  const double z = std::atanh(std::clamp(r, -0.999999, 0.999999)),
               reach = 1.645 / std::sqrt(double(truth.numel()) - 3);
  const auto squared = [](double correlation) {
    const double positive = std::max(0.0, correlation);
    return positive * positive;
  };
  return {.r_squared = squared(r),
          .lower = squared(std::tanh(z - reach)),
          .upper = squared(std::tanh(z + reach))};
}

}  // namespace

std::array<Guess, secret_count> probe(const WallPictures& train, const WallPictures& test, int epochs,
                                      std::uint64_t seed) {
  torch::manual_seed(seed);
  ProbeNetwork network;
  const torch::Tensor images = image_tensor(train), secrets = secret_tensor(train);
  const torch::Tensor mean = secrets.mean(0), deviation = secrets.std(0);
  const torch::Tensor targets = (secrets - mean) / deviation;
  torch::optim::AdamW optimiser(network.parameters(), torch::optim::AdamWOptions(2e-3).weight_decay(1e-3));
  const std::int64_t batches = std::int64_t(train.count()) / batch_size, steps = batches * epochs;
  std::int64_t step = 0;
  for (int epoch = 0; epoch < epochs; ++epoch) {
    network.train();
    const torch::Tensor order = torch::randperm(std::int64_t(train.count()));
    for (std::int64_t b = 0; b < batches; ++b, ++step) {
      const torch::Tensor chosen = order.narrow(0, b * batch_size, batch_size);
      const double progress = double(step) / double(steps);
      for (auto& group : optimiser.param_groups())
        static_cast<torch::optim::AdamWOptions&>(group.options())
            .lr(1e-3 * (1 + std::cos(std::numbers::pi * progress)));
      optimiser.zero_grad();
      const torch::Tensor guess = network.forward(normalised(images.index_select(0, chosen)));
      torch::mse_loss(guess, targets.index_select(0, chosen)).backward();
      optimiser.step();
    }
  }

  network.eval();
  const torch::NoGradGuard no_gradient;
  const torch::Tensor test_images = image_tensor(test), truth = secret_tensor(test);
  std::vector<torch::Tensor> guesses;
  for (std::int64_t first = 0; first < std::int64_t(test.count()); first += 256)
    guesses.push_back(network.forward(normalised(
        test_images.narrow(0, first, std::min<std::int64_t>(256, std::int64_t(test.count()) - first)))));
  const torch::Tensor guess = torch::cat(guesses);
  std::array<Guess, secret_count> result;
  for (int s = 0; s < secret_count; ++s)
    result[s] = judge(guess.select(1, s).to(torch::kDouble), truth.select(1, s).to(torch::kDouble));
  return result;
}

}  // namespace cps
