#include <torch/types.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "trainer/deepcalib/bins.h"
#include "trainer/deepcalib/sphere_head.h"

using namespace cps;
using torch::Tensor;

namespace {

Tensor doubles(const std::vector<double>& values) {
  return torch::tensor(values, torch::kDouble);
}

double logit(double share) {
  return std::log(share / (1 - share));
}

}  // namespace

TEST_CASE("log-cosh in closed form: value and gradient near zero and far off") {
  const Tensor zero = doubles({0});
  for (double off : {0.0, 1e-3, -.3, 2.0, -7.0, 40.0, -900.0}) {
    INFO(off);
    const Tensor x = doubles({off}).set_requires_grad(true);
    const Tensor loss = log_cosh_loss(x, zero);
    loss.backward();
    // cosh overflows beyond 710, where log cosh is |x| − log 2 to the last place.
    const double expected = std::abs(off) < 300 ? std::log(std::cosh(off)) : std::abs(off) - std::log(2.0);
    CHECK(loss.item<double>() == Approx(expected).epsilon(1e-8).margin(1e-15));
    CHECK(x.grad()[0].item<double>() == Approx(std::tanh(off)).epsilon(1e-12).margin(1e-15));
  }
  // The mean over all elements.
  CHECK(log_cosh_loss(doubles({0, 1}), doubles({0, 0})).item<double>() ==
        Approx(std::log(std::cosh(1.0)) / 2));
}

TEST_CASE("regression: sigmoids against shares and their gradient by finite differences") {
  const std::vector<SphereTarget> targets{{.2, .9}, {.5, 0}};
  const Tensor at = doubles({.3, -1.2, 2, .7}).reshape({2, 2});
  const auto loss = [&](const Tensor& rows) {
    return sphere_loss(Head::deepcalib_regression, rows, targets);
  };
  const auto sigmoid = [](double x) { return 1 / (1 + std::exp(-x)); };
  const double expected = (std::log(std::cosh(sigmoid(.3) - .2)) + std::log(std::cosh(sigmoid(-1.2) - .9)) +
                           std::log(std::cosh(sigmoid(2) - .5)) + std::log(std::cosh(sigmoid(.7)))) /
                          4;
  CHECK(loss(at).item<double>() == Approx(expected).epsilon(1e-9));
  const Tensor x = at.clone().set_requires_grad(true);
  loss(x).backward();
  constexpr double h = 1e-6;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      Tensor up = at.clone(), down = at.clone();
      up[i][k] += h;
      down[i][k] -= h;
      const double slope = (loss(up).item<double>() - loss(down).item<double>()) / (2 * h);
      CHECK(x.grad()[i][k].item<double>() == Approx(slope).margin(1e-8));
    }
}

TEST_CASE("classification: the cross entropies of both bins summed") {
  // All bins alike: log 46 + log 61, whatever the targets are.
  const std::vector<SphereTarget> targets{{.2, .9}, {1, 0}};
  const Tensor flat = torch::zeros({2, focal_bins + xi_bins}, torch::kDouble);
  CHECK(sphere_loss(Head::deepcalib_classification, flat, targets).item<double>() ==
        Approx(std::log(46.0) + std::log(61.0)));

  // One logit a raised by L: its bin costs log(1 + (n − 1) e^−L), every other bin L more.
  constexpr double raised = 3;
  const double hit_focal = std::log(1 + 45 * std::exp(-raised)),
               hit_xi = std::log(1 + 60 * std::exp(-raised));
  Tensor rows = torch::zeros({1, focal_bins + xi_bins}, torch::kDouble);
  rows[0][20] = raised;               // 250 pixels
  rows[0][focal_bins + 30] = raised;  // ξ = .6
  const auto loss_of = [&](double focal_px, double xi) {
    const std::vector<SphereTarget> one{{(focal_px - 50) / 450, xi / 1.2}};
    return sphere_loss(Head::deepcalib_classification, rows, one).item<double>();
  };
  CHECK(loss_of(250, .6) == Approx(hit_focal + hit_xi));
  CHECK(loss_of(254.9, .6) == Approx(hit_focal + hit_xi));  // up to the border of the bin
  CHECK(loss_of(245.1, .6) == Approx(hit_focal + hit_xi));
  CHECK(loss_of(255.1, .6) == Approx(hit_focal + raised + hit_xi));
  CHECK(loss_of(244.9, .6) == Approx(hit_focal + raised + hit_xi));
  CHECK(loss_of(250, .6099) == Approx(hit_focal + hit_xi));
  CHECK(loss_of(250, .6101) == Approx(hit_focal + hit_xi + raised));
}

TEST_CASE("decoding the outputs: sigmoids and the expectations of the distributions") {
  const Tensor numbers = doubles({logit(.25), logit(.8), 0, 0}).reshape({2, 2});
  const std::vector<SphereTarget> regressed = sphere_targets(Head::deepcalib_regression, numbers);
  REQUIRE(regressed.size() == 2);
  CHECK(regressed[0].focal == Approx(.25));
  CHECK(regressed[0].xi == Approx(.8));
  CHECK(regressed[1].focal == Approx(.5));

  Tensor rows = torch::full({2, focal_bins + xi_bins}, -1e4, torch::kDouble);
  rows[0][7] = 0.;  // certain of 120 pixels
  rows[0][focal_bins + 60] = 0.;
  rows[1][10] = 0.;  // as likely one as the other
  rows[1][12] = 0.;
  rows[1][focal_bins] = std::log(3.0);  // three to one
  rows[1][focal_bins + 4] = 0.;
  const std::vector<SphereTarget> expected = sphere_targets(Head::deepcalib_classification, rows);
  CHECK(expected[0].focal == Approx(7 / 45.0));
  CHECK(expected[0].xi == Approx(1));
  CHECK(expected[1].focal == Approx(11 / 45.0));
  CHECK(expected[1].xi == Approx(1 / 60.0));
  // An untrained network, whose last layer is zero, says the middle.
  const auto middle = sphere_targets(Head::deepcalib_classification, torch::zeros({1, 107}));
  CHECK(middle[0].focal == Approx(.5));
  CHECK(middle[0].xi == Approx(.5));
}
