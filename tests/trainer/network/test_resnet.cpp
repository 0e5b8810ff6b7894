#include <torch/types.h>

#include <catch2/catch.hpp>
#include <map>

#include "trainer/network/resnet.h"
#include "trainer/network/weights.h"

using namespace cps;

namespace {

std::int64_t parameter_count(const Network& network) {
  std::int64_t count = 0;
  for (const auto& p : network.parameters()) count += p.numel();
  return count;
}

/// torchvision's published total for this network with 3 channels and 1000 classes, less two of the first
/// layer's three channels (2·64·7²), its head (1001 numbers per class of `features`), plus ours: 8 rows of
/// features + 2 sizes + bias.
std::int64_t expected(std::int64_t torchvision_total, std::int64_t features) {
  return torchvision_total - 2 * 64 * 49 - 1000 * (features + 1) + 8 * (features + 2 + 1);
}

std::shared_ptr<Network> resnet(const std::string& name) {
  return make_resnet(*find_architecture(name), {});
}

}  // namespace

TEST_CASE("parameter counts are torchvision's, less two input channels and with another head") {
  CHECK(parameter_count(*resnet("resnet18")) == expected(11'689'512, 512));
  CHECK(parameter_count(*resnet("resnet34")) == expected(21'797'672, 512));
  CHECK(parameter_count(*resnet("resnet50")) == expected(25'557'032, 2048));
  CHECK(parameter_count(*resnet("resnet101")) == expected(44'549'160, 2048));
  CHECK(parameter_count(*resnet("resnet34-nopool")) == expected(21'797'672, 512));
}

TEST_CASE("parameter counts of narrow and shallow networks are those of a formula in their width") {
  // With basic blocks, c channels and c/2 before them: the first block of a stage has 9·c²/2 + 9·c² weights,
  // and c²/2 of its shortcut; each other block 18·c². A normalisation has 2·c. The first stage has no
  // shortcut.
  const auto one_block = [](std::int64_t w) { return 1194 * w * w + 203 * w + 24; };
  const auto two_blocks = [](std::int64_t w) { return 2724 * w * w + 263 * w + 24; };
  CHECK(two_blocks(64) == expected(11'689'512, 512));  // the formula for torchvision's own
  CHECK(parameter_count(*resnet("resnet18-32")) == two_blocks(32));
  CHECK(parameter_count(*resnet("resnet18-16")) == two_blocks(16));
  CHECK(parameter_count(*resnet("resnet10-32")) == one_block(32));
}

TEST_CASE("narrow networks have the names of wide ones and refuse their weights") {
  const NamedTensors wide = weights_of(*resnet("resnet18")), narrow = weights_of(*resnet("resnet18-32"));
  REQUIRE(narrow.size() == wide.size());
  for (const auto& [name, tensor] : narrow) CHECK(wide.contains(name));
  CHECK(narrow.at("layer4.1.conv2.weight").sizes().vec() == std::vector<std::int64_t>{256, 256, 3, 3});
  CHECK(narrow.at("fc.weight").sizes().vec() == std::vector<std::int64_t>{8, 258});
  CHECK_THROWS_WITH(set_weights(*resnet("resnet18-32"), wide, "model/weights.pt"),
                    Catch::Contains("another architecture"));
  CHECK_THROWS_WITH(start_from(*resnet("resnet18-16"), narrow, "narrow.pt"),
                    Catch::StartsWith("narrow.pt: "));
}

TEST_CASE("parameters and buffers carry torchvision's names and shapes") {
  // resnet18().state_dict(): conv1, bn1, then per block conv1 bn1 conv2 bn2, and downsample 0 1 where the
  // stage halves.
  std::map<std::string, std::vector<std::int64_t>> names;
  const auto batch_norm = [&](const std::string& name, std::int64_t channels) {
    for (const char* part : {".weight", ".bias", ".running_mean", ".running_var"})
      names[name + part] = {channels};
    names[name + ".num_batches_tracked"] = {};
  };
  names["conv1.weight"] = {64, 1, 7, 7};
  batch_norm("bn1", 64);
  std::int64_t in = 64;
  for (int stage = 1; stage <= 4; ++stage)
    for (int block = 0; block < 2; ++block) {
      const std::string prefix = "layer" + std::to_string(stage) + "." + std::to_string(block) + ".";
      const std::int64_t out = 32 << stage;
      names[prefix + "conv1.weight"] = {out, in, 3, 3};
      names[prefix + "conv2.weight"] = {out, out, 3, 3};
      batch_norm(prefix + "bn1", out);
      batch_norm(prefix + "bn2", out);
      if (stage > 1 && block == 0) {
        names[prefix + "downsample.0.weight"] = {out, in, 1, 1};
        batch_norm(prefix + "downsample.1", out);
      }
      in = out;
    }
  names["fc.weight"] = {8, 514};
  names["fc.bias"] = {8};

  std::map<std::string, std::vector<std::int64_t>> ours;
  for (const auto& [name, tensor] : weights_of(*resnet("resnet18"))) ours[name] = tensor.sizes().vec();
  CHECK(ours == names);

  const NamedTensors deep = weights_of(*resnet("resnet50"));
  CHECK(deep.size() == 320);  // as torchvision's state_dict
  CHECK(deep.at("layer3.5.conv2.weight").sizes().vec() == std::vector<std::int64_t>{256, 256, 3, 3});
  CHECK(deep.at("layer1.0.downsample.0.weight").sizes().vec() == std::vector<std::int64_t>{256, 64, 1, 1});
  CHECK(deep.at("fc.weight").sizes().vec() == std::vector<std::int64_t>{8, 2050});
}

TEST_CASE("any image size goes in, and the size features reach the outputs") {
  torch::manual_seed(1);
  const auto network = resnet("resnet18");
  network->eval();
  const torch::NoGradGuard no_gradients;
  for (auto& p : network->named_parameters())
    if (p.key() == "fc.weight") p.value().normal_();
  for (auto [h, w] : {std::pair{68, 120}, std::pair{64, 174}})
    CHECK(network->forward(torch::randn({3, 1, h, w}), torch::zeros({3, 2})).numbers.sizes() ==
          torch::IntArrayRef({3, 8}));
  const torch::Tensor image = torch::randn({1, 1, 64, 96});
  const torch::Tensor change = network->forward(image, torch::tensor({{.125f, .25f}})).numbers -
                               network->forward(image, torch::zeros({1, 2})).numbers;
  const torch::Tensor weight = network->named_parameters()["fc.weight"];
  CHECK(torch::allclose(change[0], .125 * weight.select(1, 512) + .25 * weight.select(1, 513), 1e-4, 1e-5));
}

TEST_CASE("without size features the size has no effect, and the last layer has two columns fewer") {
  torch::manual_seed(1);
  const auto network = make_resnet(*find_architecture("resnet18"), {.size_features = false});
  network->eval();
  const torch::NoGradGuard no_gradients;
  torch::Tensor weight = network->named_parameters()["fc.weight"];
  CHECK(weight.sizes() == torch::IntArrayRef({8, 512}));
  weight.normal_();
  const torch::Tensor image = torch::randn({1, 1, 64, 96});
  CHECK(torch::equal(network->forward(image, torch::ones({1, 2})).numbers,
                     network->forward(image, torch::zeros({1, 2})).numbers));
}

TEST_CASE("without the pooling every map is twice as large, with the same weights") {
  torch::manual_seed(1);
  const auto pooled = resnet("resnet34"), plain = resnet("resnet34-nopool");
  set_weights(*plain, weights_of(*pooled), "");  // the same names and shapes
  pooled->eval();
  plain->eval();
  for (const auto& network : {pooled, plain}) {
    torch::Tensor fc = network->named_parameters()["fc.weight"];
    const torch::NoGradGuard no_gradients;
    fc.fill_(.01);
  }
  const torch::NoGradGuard no_gradients;
  const torch::Tensor image = torch::randn({1, 1, 64, 96}), sizes = torch::zeros({1, 2});
  CHECK_FALSE(torch::allclose(pooled->forward(image, sizes).numbers, plain->forward(image, sizes).numbers));
}

TEST_CASE("an untrained network predicts the training mean for any image") {
  torch::manual_seed(1);
  const auto network = resnet("resnet50");
  network->eval();
  const torch::NoGradGuard no_gradients;
  CHECK(network->forward(torch::randn({2, 1, 64, 96}), torch::ones({2, 2}))
            .numbers.abs()
            .max()
            .item<double>() == 0);
}

TEST_CASE("weights of another architecture are refused by name") {
  const NamedTensors other = weights_of(*resnet("resnet34"));
  CHECK_THROWS_WITH(set_weights(*resnet("resnet50"), other, "model/weights.pt"),
                    Catch::StartsWith("model/weights.pt: "));
  CHECK_THROWS_WITH(set_weights(*resnet("resnet18"), other, "model/weights.pt"),
                    Catch::Contains("another architecture"));
}
