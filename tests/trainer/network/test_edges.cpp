#include <ATen/ATen.h>

#include <catch2/catch.hpp>

#include "trainer/network/edges.h"
#include "trainer/network/weights.h"

using namespace cps;

TEST_CASE("the edge of a slope is its gradient's length") {
  const torch::Tensor x = torch::arange(9).to(torch::kFloat).view({1, 9}),
                      y = torch::arange(7).to(torch::kFloat).view({7, 1});
  const torch::Tensor both = with_sobel_edges((.3 * x - .4 * y + 5).view({1, 1, 7, 9}));
  REQUIRE(both.sizes() == torch::IntArrayRef({1, 2, 7, 9}));
  CHECK(torch::equal(both.select(1, 0)[0], .3 * x - .4 * y + 5));
  const torch::Tensor edges = both.select(1, 1)[0];
  CHECK(torch::allclose(edges.slice(0, 1, 6).slice(1, 1, 8), torch::full({5, 7}, .5), 1e-5, 1e-5));
  // At the left border the outermost pixels repeat: half the slope across, all of it down.
  CHECK(edges[3][0].item<double>() == Approx(std::hypot(.15, .4)).epsilon(1e-5));
  CHECK(with_sobel_edges(torch::full({1, 1, 4, 4}, 3.)).select(1, 1).abs().max().item<double>() == 0);
}

TEST_CASE("a mirrored image has mirrored edges") {
  torch::manual_seed(3);
  const torch::Tensor images = torch::randn({2, 1, 8, 11});
  CHECK(torch::allclose(with_sobel_edges(images.flip(3)), with_sobel_edges(images).flip(3), 1e-5, 1e-6));
}

TEST_CASE("a network with an edge channel that starts from gray weights predicts what they predict") {
  torch::manual_seed(1);
  const Architecture& resnet18 = *find_architecture("resnet18");
  const auto gray = make_resnet(resnet18, {}), edges = make_resnet(resnet18, {.edge_channel = true});
  for (auto& p : gray->named_parameters()) {
    const torch::NoGradGuard no_gradients;
    if (p.key() == "fc.weight") p.value().normal_();
  }
  start_from(*edges, weights_of(*gray), "gray.pth");
  gray->eval();
  edges->eval();
  const torch::NoGradGuard no_gradients;
  const torch::Tensor images = torch::randn({2, 1, 64, 96}), sizes = torch::zeros({2, 2});
  const torch::Tensor expected = gray->forward(images, sizes).numbers;
  CHECK(torch::allclose(edges->forward(images, sizes).numbers, expected, 1e-4, 1e-5));
  for (auto& p : edges->named_parameters())
    if (p.key() == "conv1.weight") p.value().select(1, 1).fill_(.1);
  CHECK_FALSE(torch::allclose(edges->forward(images, sizes).numbers, expected, 1e-2,
                              1e-2));  // the edges have an effect
  CHECK_THROWS_WITH(set_weights(*edges, weights_of(*gray), "gray.pt"), Catch::Contains("conv1.weight"));
}
