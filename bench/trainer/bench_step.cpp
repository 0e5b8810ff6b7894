#include <benchmark/benchmark.h>

#include "trainer/training/training_state.h"

namespace {

/// Forward, backward and optimiser step of one batch of 16 images of `width` × 9/16 `width`. Items are
/// images.
void training_step(benchmark::State& state, const std::string& architecture) {
  const std::int64_t width = state.range(0), height = width * 9 / 16, batch = 16;
  cps::TrainOptions options;
  options.architecture = architecture;
  const cps::TrainingState training = cps::fresh_training_state(options);
  training.network->train();
  const torch::Tensor images = torch::randn({batch, 1, height, width}), sizes = torch::zeros({batch, 2}),
                      targets = torch::randn({batch, cps::output_count});
  for (auto _ : state) {
    training.optimizer->zero_grad();
    torch::mse_loss(training.network->forward(images, sizes), targets).backward();
    training.optimizer->step();
  }
  state.SetItemsProcessed(state.iterations() * batch);
}

void steps(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK_CAPTURE(training_step, resnet18, "resnet18")->Arg(120)->Arg(160)->Arg(240)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet34, "resnet34")->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet50, "resnet50")->Arg(160)->Apply(steps);
