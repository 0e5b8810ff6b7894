#include <torch/types.h>

#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "trainer/network/autocast.h"
#include "trainer/network/tensor_file.h"
#include "trainer/network/weights.h"

using namespace cps;
using torch::Tensor;

namespace {

/// A narrow network whose every layer reaches the outputs: blocks and the last layer do not start at zero.
std::shared_ptr<Network> random_network(const std::string& architecture) {
  torch::manual_seed(1);
  const auto network = make_resnet(*find_architecture(architecture), {});
  const torch::NoGradGuard no_gradients;
  for (auto& [name, tensor] : weights_of(*network))
    if (name == "fc.weight")
      tensor.normal_(0, .1);
    else if (name.ends_with(".bn2.weight"))
      tensor.fill_(.5);
  network->train();
  return network;
}

struct Pass {
  Tensor outputs, gradient;  ///< of all parameters in one row
};

Pass train_pass(Network& network, Precision precision) {
  torch::manual_seed(2);
  const Tensor images = torch::randn({8, 1, 48, 64}), sizes = torch::rand({8, 2}),
               targets = torch::randn({8, 8});
  network.training_precision = precision;
  for (Tensor& parameter : network.parameters()) parameter.mutable_grad().reset();
  const Tensor outputs = network.forward(images, sizes).numbers;
  at::mse_loss(outputs, targets).backward();
  std::vector<Tensor> gradients;
  for (const Tensor& parameter : network.parameters()) {
    REQUIRE(parameter.grad().scalar_type() == torch::kFloat);
    gradients.push_back(parameter.grad().flatten());
  }
  return {outputs.detach(), at::cat(gradients)};
}

double length(const Tensor& tensor) {
  return tensor.norm().item<double>();
}

}  // namespace

TEST_CASE("precisions are found by name") {
  for (Precision precision : {Precision::automatic, Precision::float32, Precision::bfloat16})
    CHECK(precision_from_string(to_string(precision)) == precision);
  CHECK_THROWS_WITH(precision_from_string("float16"),
                    "precision 'float16': unknown: use auto, float32 or bfloat16");
}

TEST_CASE("auto is bfloat16 only where that is computed and any other wish stays") {
  CHECK(chosen_precision(Precision::automatic, true) == Precision::bfloat16);
  CHECK(chosen_precision(Precision::automatic, false) == Precision::float32);
  for (bool computed : {false, true}) {
    CHECK(chosen_precision(Precision::float32, computed) == Precision::float32);
    CHECK(chosen_precision(Precision::bfloat16, computed) == Precision::bfloat16);
  }
}

TEST_CASE("the processor is asked as Linux asks it") {
  const std::string cpus = read_file("/proc/cpuinfo");
  const bool listed =
      cpus.find(" avx512_bf16") != std::string::npos || cpus.find(" amx_bf16") != std::string::npos;
  CHECK(processor_computes_bfloat16() == listed);
}

TEST_CASE("the report says what was used and what this processor does") {
  CHECK(precision_report(Precision::bfloat16, true) == "precision bfloat16, which this processor computes");
  CHECK_THAT(precision_report(Precision::bfloat16, false), Catch::Contains("only emulates"));
  CHECK(precision_report(Precision::float32, false) ==
        "precision float32; this processor does not compute bfloat16");
}

TEST_CASE("a convolution in bfloat16 is that of the rounded numbers and ends with its scope") {
  torch::manual_seed(1);
  const Tensor images = torch::randn({2, 3, 12, 10}), kernels = torch::randn({8, 3, 3, 3});
  const Tensor before = at::conv2d(images, kernels);
  Tensor rounded;
  {
    const Autocast autocast(Precision::bfloat16);
    rounded = at::conv2d(images, kernels);
  }
  REQUIRE(rounded.scalar_type() == torch::kBFloat16);
  const auto to_bfloat16 = [](const Tensor& t) { return t.to(torch::kBFloat16).to(torch::kDouble); };
  const Tensor exact = at::conv2d(to_bfloat16(images), to_bfloat16(kernels));
  // The result is rounded to 8 significant bits. The sums before are in float32, but for emulations.
  const double of_sums = processor_computes_bfloat16() ? 1e-4 : .05;
  const Tensor error = (rounded.to(torch::kDouble) - exact).abs();
  CHECK((error <= exact.abs() / 256 + of_sums).all().item<bool>());
  CHECK(length(rounded.to(torch::kFloat) - before) > 1e-3 * length(before));

  CHECK(torch::equal(at::conv2d(images, kernels), before));
  const Autocast none(Precision::float32);
  CHECK(torch::equal(at::conv2d(images, kernels), before));
}

TEST_CASE("a pass in bfloat16 is close to that in float32 and returns float32") {
  const auto network = random_network(GENERATE(as<std::string>{}, "resnet10-32", "resnet18-16"));
  const Pass exact = train_pass(*network, Precision::float32);
  if (GENERATE(false, true)) use_channels_last(*network);
  const Pass rounded = train_pass(*network, Precision::bfloat16);
  CHECK(rounded.outputs.scalar_type() == torch::kFloat);
  // Each of some twenty layers rounds to 8 bits, .2 % of a number on average: 1 to 2 % in all.
  const double difference = length(rounded.outputs - exact.outputs) / length(exact.outputs);
  CHECK(difference < .05);
  CHECK(difference > 1e-4);  // it is not float32 under another name
  const double cosine = (rounded.gradient * exact.gradient).sum().item<double>() /
                        (length(rounded.gradient) * length(exact.gradient));
  CHECK(cosine > .9);
}

TEST_CASE("the layout of kernels changes neither their values nor a file") {
  const TemporaryFolder folder;
  const auto plain = random_network("resnet10-32"), inner = random_network("resnet10-32");
  use_channels_last(*inner);
  for (const auto& parameter : inner->named_parameters())
    if (parameter.value().dim() == 4)
      CHECK(parameter.value().is_contiguous(at::MemoryFormat::ChannelsLast));
    else
      CHECK(parameter.value().is_contiguous());
  const NamedTensors before = weights_of(*plain), after = weights_of(*inner);
  for (const auto& [name, tensor] : before) CHECK(torch::equal(tensor, after.at(name)));
  CHECK_FALSE(after.at("layer1.0.conv1.weight").is_contiguous());
  save_tensors(before, folder.path / "plain.pt");
  save_tensors(after, folder.path / "inner.pt");
  const bool is_equal = read_file(folder.path / "plain.pt") == read_file(folder.path / "inner.pt");
  CHECK(is_equal);
}

TEST_CASE("evaluation is in float32 whatever a network was trained in") {
  const auto network = random_network("resnet18-16");
  network->eval();
  const torch::NoGradGuard no_gradients;
  torch::manual_seed(3);
  const Tensor images = torch::randn({2, 1, 32, 48}), sizes = torch::rand({2, 2});
  const Tensor outputs = network->forward(images, sizes).numbers;
  network->training_precision = Precision::bfloat16;
  CHECK(torch::equal(network->forward(images, sizes).numbers, outputs));
}
