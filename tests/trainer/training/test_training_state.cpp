#include <torch/types.h>

#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"
#include "trainer/network/tensor_file.h"
#include "trainer/training/training_state_file.h"

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

TEST_CASE("a state is restored with its history, every number under its name") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "state.pt";
  TrainingState state = fresh_training_state({});
  state.planned_epochs = 40;
  state.steps = 123;
  double next = .5;  // every field of every epoch another number
  for (int epoch = 1; epoch <= 11; ++epoch) {
    state.epochs.emplace_back();
    for_each_field(state.epochs.back(), [&]<typename Field>(const char*, Field& field) {
      field = static_cast<Field>(next);
      next += 1.25;
    });
  }
  save_training_state(state, file);
  const TrainingState restored = load_training_state({}, file);
  CHECK(restored.planned_epochs == 40);
  CHECK(restored.steps == 123);
  REQUIRE(restored.epochs.size() == 11);
  CHECK(restored.epochs[3].validation_loss == state.epochs[3].validation_loss);
  for (int e = 0; e < 11; ++e) {
    std::vector<double> before, after;
    for_each_field(state.epochs[e], [&](const char*, auto value) { before.push_back(value); });
    for_each_field(restored.epochs[e], [&](const char*, auto value) { after.push_back(value); });
    CHECK(before == after);
  }
  // The file has a column for each field, under its name.
  const NamedTensors tensors = load_tensors(file);
  CHECK(tensors.at("history.loader_share")[4].item<double>() == state.epochs[4].loader_share);
}

TEST_CASE("a state of another version, or without a part of its history, is refused") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "state.pt";
  TrainingState state = fresh_training_state({});
  state.epochs.resize(2);
  save_training_state(state, file);
  const NamedTensors whole = load_tensors(file);
  const auto refusal = [&](auto change) {
    NamedTensors tensors = whole;
    change(tensors);
    save_tensors(tensors, file);
    try {
      load_training_state({}, file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(refusal([](NamedTensors& t) { t.erase("version"); }), Catch::Contains("another version"));
  CHECK_THAT(refusal([](NamedTensors& t) { t["version"] = torch::tensor(1, torch::kLong); }),
             Catch::Contains("another version"));
  CHECK_THAT(refusal([](NamedTensors& t) { t.erase("history.seconds_left"); }), Catch::Contains("history"));
  CHECK_THAT(refusal([](NamedTensors& t) { t.erase("optimizer"); }), Catch::Contains("optimizer"));
  CHECK(refusal([](NamedTensors&) {}) == "");
}
