// train_on_request BATCH WIDTH HEIGHT STEPS THREADS ARCH PRECISION [bare] [channels-last]: for each line on
// stdin, trains the network for STEPS steps on images in memory as `cps train` does, and prints the wall and
// CPU seconds that took. compare_with_python.py runs it in turns with Python's torch. With `bare`, does
// exactly what the Python program does: forward, backward, clip and AdamW on one batch, without a loader.
// With `channels-last`, kernels have that layout in float32, too; `cps train` uses it for bfloat16 only.
#include <torch/nn/module.h>
#include <torch/nn/utils/clip_grad.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "random/counter_hash.h"
#include "trainer/network/autocast.h"
#include "trainer/network/threads.h"
#include "trainer/training/epoch.h"

using namespace cps;

namespace {

TrainingSet noise_images(ImageSize size, int count) {
  const Stream noise = make_stream(1, "bench");
  TrainingSet set{.originals = std::vector<ImageSize>(count, size),
                  .pixels = {.mean = 128, .deviation = 74},
                  .targets = {},
                  .skipped = {},
                  .shown = {}};
  GrayImage image{size, std::vector<std::uint8_t>(pixel_count(size))};
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(random_bits(noise, i));
  set.targets.deviation.fill(1);
  set.shown = [image, noise](int i, int) {
    ShownImage shown{.pixels = image, .original = image.size};
    for (int k = 0; k < output_count; ++k) shown.target[k] = random_uniform(substream(noise, i), k, -1, 1);
    return shown;
  };
  return set;
}

void bare_steps(TrainingState& state, int batch, ImageSize size, int steps) {
  const torch::Tensor images = torch::randn({batch, 1, size.height, size.width}),
                      sizes = torch::zeros({batch, 2}), targets = torch::randn({batch, output_count});
  state.network->train();
  for (int i = 0; i < steps; ++i) {
    state.optimizer->zero_grad();
    const torch::Tensor loss = torch::mse_loss(state.network->forward(images, sizes).numbers, targets);
    loss.backward();
    torch::nn::utils::clip_grad_norm_(state.network->parameters(), 1.0);
    state.optimizer->step();
    loss.item<double>();
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 7)
    throw std::runtime_error(
        "usage: train_on_request BATCH WIDTH HEIGHT STEPS THREADS ARCH PRECISION [bare] [channels-last]");
  const int batch = std::stoi(words[0]), steps = std::stoi(words[3]);
  const ImageSize size{std::stoi(words[1]), std::stoi(words[2])};
  const auto asked = [&](const char* word) {
    return std::find(words.begin() + 7, words.end(), word) != words.end();
  };
  const bool is_bare = asked("bare");
  use_threads(std::stoi(words[4]));

  ModelCard card;
  card.options.size_features = false;
  card.options.batch_size = batch;
  card.options.architecture = words[5];
  card.options.precision = chosen_precision(precision_from_string(words[6]), processor_computes_bfloat16());
  if (const std::string fault = card.options.fault(); !fault.empty()) throw std::runtime_error(fault);
  const TrainingSet set = noise_images(size, batch * steps);
  card.pixels = set.pixels;
  card.targets = set.targets;
  TrainingState state = fresh_training_state(card.options);
  if (asked("channels-last")) use_channels_last(*state.network);
  for (std::string line; std::getline(std::cin, line);) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    EpochReport report;
    report.epoch = 2;
    if (is_bare)
      bare_steps(state, batch, size, steps);
    else
      train_epoch(state, set, card, nullptr, Ranks(), report);
    std::cout << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() << " "
              << static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC << std::endl;
  }
} catch (const std::exception& error) {
  std::cerr << "train_on_request: " << error.what() << "\n";
  return 1;
}
