#include <benchmark/benchmark.h>

#include "trainer/training/training_state.h"

namespace {

using cps::Precision;

/// Forward, backward and optimiser step of one batch of 16 images of `width` × 9/16 `width`. Items are
/// images.
void training_step(benchmark::State& state, const std::string& architecture, Precision precision) {
  const std::int64_t width = state.range(0), height = width * 9 / 16, batch = 16;
  cps::TrainOptions options;
  options.architecture = architecture;
  options.precision = precision;
  const cps::TrainingState training = cps::fresh_training_state(options);
  training.network->train();
  const torch::Tensor images = torch::randn({batch, 1, height, width}), sizes = torch::zeros({batch, 2}),
                      targets = torch::randn({batch, cps::output_count});
  for (auto _ : state) {
    training.optimizer->zero_grad();
    torch::mse_loss(training.network->forward(images, sizes).numbers, targets).backward();
    training.optimizer->step();
  }
  state.SetItemsProcessed(state.iterations() * batch);
}

void steps(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK_CAPTURE(training_step, resnet18, "resnet18", Precision::float32)
    ->Arg(120)
    ->Arg(160)
    ->Arg(240)
    ->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet34, "resnet34", Precision::float32)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet50, "resnet50", Precision::float32)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet18_32, "resnet18-32", Precision::float32)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet18_16, "resnet18-16", Precision::float32)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet10_32, "resnet10-32", Precision::float32)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet18_bfloat16, "resnet18", Precision::bfloat16)->Arg(160)->Apply(steps);
BENCHMARK_CAPTURE(training_step, resnet18_32_bfloat16, "resnet18-32", Precision::bfloat16)
    ->Arg(160)
    ->Apply(steps);
