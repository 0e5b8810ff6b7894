#include <torch/types.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/temporary_folder.h"
#include "trainer/network/weights.h"

using namespace cps;

namespace {

const std::string weights_file = "model/weights.pt";

std::shared_ptr<Network> small_network() {
  torch::manual_seed(5);
  return make_resnet(*find_architecture("resnet10-32"), {});
}

bool is_statistic(const std::string& name) {
  return name.find("running_") != name.npos || name.ends_with("num_batches_tracked");
}

/// The first numbers of a tensor of a network, to write to.
torch::Tensor first_numbers(const Network& network, const std::string& name, std::int64_t count) {
  return weights_of(network).at(name).detach().view({-1}).slice(0, 0, count);
}

}  // namespace

TEST_CASE("weights in half are within half a unit of their last place and statistics stay as they are") {
  const auto network = small_network();
  for (const auto& [name, tensor] : weights_of(*network)) {
    if (!tensor.is_floating_point()) continue;
    // Magnitudes over all that half can say and below, up to 61,000, with either sign.
    const torch::Tensor magnitude = torch::empty_like(tensor).uniform_(-30, 15.9).exp2_();
    const torch::Tensor sign = torch::empty_like(tensor).uniform_(-1, 1).sign_();
    tensor.detach().copy_(is_statistic(name) ? magnitude * 1e3 : magnitude * sign);
  }
  const NamedTensors full = weights_of(*network), half = half_weights_of(*network, weights_file);
  REQUIRE(half.size() == full.size());
  std::int64_t changed = 0;
  for (const auto& [name, tensor] : full) {
    INFO(name);
    const torch::Tensor& kept = half.at(name);
    if (is_statistic(name)) {
      CHECK((kept.scalar_type() == tensor.scalar_type()));
      CHECK(torch::equal(kept, tensor));
      continue;
    }
    CHECK((kept.scalar_type() == torch::kHalf));
    const torch::Tensor exact = tensor.detach().to(torch::kDouble);
    const torch::Tensor error = (kept.to(torch::kDouble) - exact).abs();
    const torch::Tensor bound = (exact.abs() * std::ldexp(1., -11)).clamp_min(std::ldexp(1., -25));
    CHECK(error.le(bound).all().item<bool>());
    changed += error.gt(0).sum().item<std::int64_t>();
  }
  CHECK(changed > 1'000'000);  // most of them are no halves, so a copy without rounding would fail
}

TEST_CASE("every number that half has survives file and network exactly") {
  // By half's definition (IEEE 754, binary16): a sign, 5 bits of exponent, 10 bits of fraction.
  std::vector<float> numbers;
  std::vector<std::int16_t> patterns;
  for (int pattern = 0; pattern < 1 << 16; ++pattern) {
    const int exponent = pattern >> 10 & 31, fraction = pattern & 1023;
    if (exponent == 31) continue;  // infinite, or no number
    const double magnitude =
        exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    numbers.push_back(static_cast<float>(pattern >> 15 ? -magnitude : magnitude));
    patterns.push_back(static_cast<std::int16_t>(pattern));
  }
  const auto count = static_cast<std::int64_t>(numbers.size());
  const std::string name = "layer4.0.conv2.weight";
  const auto network = small_network(), read = small_network();
  first_numbers(*network, name, count).copy_(torch::tensor(numbers));

  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "weights.pt";
  save_tensors(half_weights_of(*network, weights_file), file);
  const NamedTensors half = load_tensors(file);
  CHECK(torch::equal(half.at(name).view({-1}).slice(0, 0, count).view(torch::kShort),
                     torch::tensor(patterns, torch::kShort)));
  set_weights(*read, half, file);
  CHECK((weights_of(*read).at(name).scalar_type() == torch::kFloat));
  CHECK(torch::equal(first_numbers(*read, name, count), torch::tensor(numbers)));
}

TEST_CASE("a weight beyond half is refused in one line that names it") {
  const auto network = small_network();
  const std::string name = "layer2.0.conv1.weight";
  torch::Tensor weight = first_numbers(*network, name, 1);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  // 65520 lies in the middle between the largest half and the next that there would be.
  for (const float number : {65520.f, -70000.f, 1e30f, infinity, -infinity, std::nanf("")}) {
    INFO(number);
    weight.fill_(number);
    CHECK_THROWS_WITH(half_weights_of(*network, weights_file),
                      Catch::StartsWith(weights_file + ": " + name + ": ") && Catch::Contains("float32") &&
                          !Catch::Contains("\n"));
  }
  weight.fill_(65519.f);
  CHECK(half_weights_of(*network, weights_file).at(name).view({-1})[0].item<float>() == 65504);
  first_numbers(*network, "bn1.running_var", 1).fill_(1e6);
  CHECK(half_weights_of(*network, weights_file).at("bn1.running_var")[0].item<float>() == 1e6f);
}

TEST_CASE("a network starts from weights in half as from the same numbers in float") {
  NamedTensors half = half_weights_of(*small_network(), weights_file), wide;
  half["conv1.weight"] = torch::randn({32, 3, 7, 7}).to(torch::kHalf);
  for (const auto& [name, tensor] : half)
    wide[name] = tensor.is_floating_point() ? tensor.to(torch::kFloat) : tensor;
  const auto from_half = small_network(), from_wide = small_network();
  start_from(*from_half, half, "half.pt");
  start_from(*from_wide, wide, "wide.pt");
  const NamedTensors expected = weights_of(*from_wide);
  for (const auto& [name, tensor] : weights_of(*from_half)) {
    INFO(name);
    const bool is_summed = name == "conv1.weight";  // over the colours, in float
    CHECK((is_summed ? torch::allclose(tensor, expected.at(name), 1e-6, 1e-7)
                     : torch::equal(tensor, expected.at(name))));
  }
}
