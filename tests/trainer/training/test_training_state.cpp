#include <torch/types.h>

#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"
#include "trainer/training/training_state.h"

using namespace cps;

TEST_CASE("the running mean of the weights follows its recurrence, and counts are copied") {
  TrainOptions options;
  options.ema_decay = .9;
  TrainingState state = fresh_training_state(options);
  const auto first = [](const Network& network) {
    return network.parameters()[0].flatten()[0].item<double>();
  };
  double expected = first(*state.network);
  CHECK(first(*state.average) == expected);
  for (int step = 1; step <= 200; ++step) {
    {
      const torch::NoGradGuard no_gradients;
      state.network->parameters()[0].add_(.1);
      state.network->buffers()[0].fill_(step);
    }
    state.steps = step;
    update_average(state, options.ema_decay);
    const double keep = std::min(.9, (1. + step) / (10. + step));
    expected = keep * expected + (1 - keep) * first(*state.network);
    CHECK(first(*state.average) == Approx(expected).epsilon(1e-4));
    CHECK(state.average->buffers()[0].flatten()[0].item<double>() == step);
  }
  // A ramp of slope .1 is followed with a lag of .1 · .9/(1 − .9).
  CHECK(first(*state.network) - first(*state.average) == Approx(.9).epsilon(1e-2));
  CHECK(&state.judged() == state.average.get());
  CHECK_FALSE(fresh_training_state({}).average);
}

TEST_CASE("a state is restored with its history; one with another version's history is refused") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "state.pt";
  TrainingState state = fresh_training_state({});
  for (int epoch = 1; epoch <= 11; ++epoch)
    state.epochs.push_back({.epoch = epoch, .images_per_second = 20, .loader_share = .25, .is_best = true});
  save_training_state(state, file);
  const TrainingState restored = load_training_state({}, file);
  REQUIRE(restored.epochs.size() == 11);
  CHECK(restored.epochs.back().epoch == 11);
  CHECK(restored.epochs.back().loader_share == .25);
  CHECK(restored.epochs.back().is_best);

  NamedTensors tensors = load_tensors(file);
  for (const int numbers : {10, 11 * 10}) {  // one epoch, or as many as numbers are known today
    tensors["history"] = torch::ones({2 + numbers}, torch::kDouble);
    save_tensors(tensors, file);
    CHECK_THROWS_WITH(load_training_state({}, file), Catch::Contains("another version"));
  }
}
