#include <torch/types.h>

#include <catch2/catch.hpp>

#include "tests/trainer/street.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/training/losses.h"

using namespace cps;
using torch::Tensor;

namespace {

const Standardisation by{{1.2, -.1, .02, 0, 0, 0, .5, .5}, {.3, .08, .03, .01, .004, .004, .02, .03}};

Tensor row(const Outputs& values) {
  return torch::tensor(std::vector<double>(values.begin(), values.end()), torch::kDouble).unsqueeze(0);
}

RayBatch rays_of(const CalibratedCamera& truth, const RayGrid& grid) {
  const long points = static_cast<long>(grid.pixels.size());
  RayBatch rays{torch::empty({1, points, 2}, torch::kDouble), torch::empty({1, points, 2}, torch::kDouble),
                truth.pinhole.width, truth.pinhole.height};
  for (long i = 0; i < points; ++i)
    for (int axis : {0, 1}) {
      rays.ideal[0][i][axis] = grid.ideal[i][axis];
      rays.pixels[0][i][axis] = grid.pixels[i][axis];
    }
  return rays;
}

/// Largest difference between the gradient and central differences.
template <typename Function>
double gradient_error(const Tensor& at, Function loss) {
  const Tensor x = at.clone().set_requires_grad(true);
  loss(x).backward();
  double worst = 0;
  const double h = 1e-6;
  for (int i = 0; i < output_count; ++i) {
    Tensor up = at.clone(), down = at.clone();
    up[0][i] += h;
    down[0][i] -= h;
    const double slope = (loss(up).template item<double>() - loss(down).template item<double>()) / (2 * h);
    worst = std::max(worst, std::abs(slope - x.grad()[0][i].template item<double>()));
  }
  return worst;
}

}  // namespace

TEST_CASE("squared and Huber errors in closed form, over the learned outputs alone") {
  const Tensor said = row({0, 3, 0, 0, 0, 0, 0, .5}), truth = row({1, 0, 0, 0, 0, 0, 7, 0});
  TrainOptions all, two;
  two.outputs = {"fov", "k1"};
  const auto loss = [&](Loss kind, const TrainOptions& o) {
    return output_loss(kind, said, truth, output_mask(o)).item<double>();
  };
  CHECK(loss(Loss::mse, all) == Approx((1 + 9 + 49 + .25) / 8));
  CHECK(loss(Loss::mse, two) == Approx((1 + 9) / 2.));
  CHECK(loss(Loss::huber, all) == Approx((.5 + 2.5 + 6.5 + .125) / 8));
  CHECK(loss(Loss::huber, two) == Approx((.5 + 2.5) / 2));
}

TEST_CASE("gradients of all losses are those of finite differences") {
  const Tensor said = row({.3, -.4, .7, 1.6, -.2, .9, -.3, .1}), truth = row({.1, .2, -2, .3, 0, .5, .4, .2});
  TrainOptions all;
  for (Loss kind : {Loss::mse, Loss::huber})
    CHECK(gradient_error(
              said, [&](const Tensor& x) { return output_loss(kind, x, truth, output_mask(all)); }) < 1e-7);
  for (std::uint64_t lens : {0, 4, 9}) {
    const CalibratedCamera calibration = draw_calibration({480, 270}, 75, lens);
    const RayBatch rays = rays_of(calibration, ray_grid(calibration, 12).value());
    for (TargetSpace space : {TargetSpace::raw, TargetSpace::apparent})
      CHECK(gradient_error(said, [&](const Tensor& x) { return reprojection_loss(x, rays, space, by); }) <
            2e-5);
  }
}

TEST_CASE("the reprojection loss is the reprojection error") {
  for (std::uint64_t lens : {2, 5}) {
    const CalibratedCamera truth = draw_calibration({480, 270}, 80, lens),
                           other = draw_calibration({480, 270}, 74, 7);
    const RayGrid grid = ray_grid(truth, 12).value();
    for (TargetSpace space : {TargetSpace::raw, TargetSpace::apparent}) {
      const auto loss = [&](const CalibratedCamera& c) {
        return reprojection_loss(row(standardise(to_outputs(c, space), by)), rays_of(truth, grid), space, by)
                   .item<double>() *
               4.80;
      };
      CHECK(loss(other) == Approx(reprojection_error_px(grid, other)).epsilon(1e-6));
      CHECK(loss(truth) == Approx(0).margin(1e-4));
    }
  }
}

TEST_CASE("an H-FOV outside 0…180° has a finite loss and no gradient of its own") {
  const CalibratedCamera truth = draw_calibration({480, 270}, 80, 2);
  const RayBatch rays = rays_of(truth, ray_grid(truth, 12).value());
  const Tensor x = row({-30, 0, 0, 0, 0, 0, 0, 0}).set_requires_grad(true);
  const Tensor loss = reprojection_loss(x, rays, TargetSpace::apparent, by);
  loss.backward();
  CHECK(std::isfinite(loss.item<double>()));
  CHECK(x.grad()[0][0].item<double>() == 0);
}
