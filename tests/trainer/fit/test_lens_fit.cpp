#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/angles.h"
#include "tests/trainer/fit/evidence.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "trainer/calibration/lens_posterior.h"
#include "trainer/images/network_image.h"

using namespace cps;

namespace {

constexpr ImageSize wide_frame{1392, 512};

/// The edges of a drawn picture in the fit's blocks, all of one precision.
FrameEvidence drawn_evidence(const GrayImage& picture, const LensPrior& prior, float precision) {
  const NetworkImage image = network_image(picture, {.width = 174}, {.measured = true});
  EdgeBlocks edges = measured_edges(batch_image(image, picture.size));
  const ImageSize cells = image.orientation.grid, grid = fit_grid(cells);
  FrameEvidence frame{prior, {picture.size, grid, {}, {}}, fit_block_centres(picture.size, cells)};
  const std::size_t blocks = static_cast<std::size_t>(grid.width) * grid.height;
  frame.edges.weight.resize(edge_families * blocks);
  frame.edges.weighted_tilt.resize(edge_families * blocks);
  std::size_t i = 0;
  for (int family = 0; family < edge_families; ++family)
    for (int y = 0; y < edges.grid.height; ++y)
      for (int x = 0; x < edges.grid.width; ++x, ++i) {
        const std::size_t block = family * blocks +
                                  static_cast<std::size_t>(y / weights_per_block) * grid.width +
                                  x / weights_per_block;
        frame.edges.weight[block] += precision * edges.weight[i];
        frame.edges.weighted_tilt[block] += precision * edges.weighted_tilt[i];
      }
  return frame;
}

}  // namespace

TEST_CASE("without edges a fit gives the prior back") {
  const LensPrior prior = wide_prior(wide_frame);
  const FrameEvidence frame = synthetic_evidence(prior, prior.mean, wide_frame, 0, make_stream(1, "none"));
  const LensFit fit = fit_lens(frame);
  CHECK(fit.parameters == prior.mean);
  CHECK(fit.information == prior.precision);
  CHECK(fit.iterations == 0);
}

TEST_CASE("errors of a fit are those that its covariance states") {
  // With the truth drawn from the prior and normal errors of the tilts, error · information · error has a χ²
  // distribution of 11 degrees of freedom; the sum over the cameras is within the 99.9 % interval of its own
  // (3.29 standard deviations), and a little more for what the model is not linear.
  constexpr int cameras = 120;
  const LensPrior prior = wide_prior(wide_frame);
  double sum = 0, fitted = 0, guessed = 0;
  for (int i = 0; i < cameras; ++i) {
    const Stream stream = substream(make_stream(2, "camera"), i);
    const FitVector truth = drawn(prior, stream);
    const LensFit fit = fit_lens(synthetic_evidence(prior, truth, wide_frame, 400, stream));
    const FitVector error = fit.parameters - truth;
    sum += error.dot(fit.information * error);
    fitted += std::abs(error[1]) / cameras;
    guessed += std::abs(prior.mean[1] - truth[1]) / cameras;
  }
  const double expected = double(fit_parameter_count) * cameras;
  CHECK(sum == Approx(expected).margin(3.29 * std::sqrt(2 * expected) + .03 * expected));
  CHECK(fitted < .6 * guessed);  // edges say K1, as far as K2 and K3 let them
}

TEST_CASE("a fit ends where the gradient vanishes") {
  const LensPrior prior = wide_prior(wide_frame);
  const Stream stream = make_stream(5, "gradient");
  const FrameEvidence frame = synthetic_evidence(prior, drawn(prior, stream), wide_frame, 400, stream);
  const LensFit fit = fit_lens(frame, 30);
  const FitVector pull =
      edge_equations(frame, fit.model).pull - prior.precision * (fit.parameters - prior.mean);
  const FitVector step = fit.information.inverse() * pull;
  CHECK(step.dot(pull) < 1e-6);
}

TEST_CASE("losing the tilts of blocks costs more than any tilts that they may have") {
  const LensPrior prior = wide_prior(wide_frame);
  const FrameEvidence frame = synthetic_evidence(prior, prior.mean, wide_frame, 400, make_stream(7, "edges"));
  const auto cost_at_roll = [&](double roll_deg) {
    FitVector parameters = prior.mean;
    parameters[roll_parameter] = radians(roll_deg);
    return edge_equations(frame, tilt_model(frame, parameters)).cost;
  };
  CHECK(cost_at_roll(0) < cost_at_roll(10));
  CHECK(cost_at_roll(10) < cost_at_roll(20));
  CHECK(cost_at_roll(20) < cost_at_roll(30));  // a tilt of .58, which no block has
}

TEST_CASE("more certain edges give a smaller covariance and a pull to what they say") {
  const LensPrior prior = wide_prior(wide_frame);
  FitVector truth = prior.mean;
  truth[1] -= .1;
  const auto fit_with = [&](double weight) {
    return fit_lens(synthetic_evidence(prior, truth, wide_frame, weight, make_stream(9, "edges")));
  };
  const LensFit vague = fit_with(5), sharp = fit_with(5000);
  CHECK(sharp.information.inverse()(1, 1) < .1 * vague.information.inverse()(1, 1));
  CHECK(std::abs(sharp.parameters[1] - truth[1]) < 3 * std::sqrt(sharp.information.inverse()(1, 1)));
}

TEST_CASE("the edges of a drawn wall give the lens that it was seen through") {
  for (double k1 : {-.12, -.06, .12}) {
    LensPrior prior = wide_prior({696, 256});
    FitVector truth = prior.mean;
    truth[1] = k1;
    truth[2] = truth[3] = 0;
    prior.mean[1] = 0;
    prior.mean[2] = prior.mean[3] = 0;
    prior.precision(1, 1) = 1 / (.3 * .3);
    prior.precision(2, 2) = prior.precision(3, 3) = 1e8;  // the wall is of k1 alone
    Outputs outputs;
    for (int i = 0; i < output_count; ++i) outputs[i] = truth[i];
    const GrayImage wall = wall_grid(*to_camera(outputs, TargetSpace::seen, 696, 256));
    const LensFit fit = fit_lens(drawn_evidence(wall, prior, 100), 20);
    CHECK(fit.parameters[1] == Approx(k1).margin(.02));
    CHECK(fit.parameters[roll_parameter] == Approx(0).margin(radians(.3)));
  }
}

TEST_CASE("a flipped image has the flipped edges") {
  const GrayImage picture = leaning_bars({200, 88}, .1);
  const NetworkImage image = network_image(picture, {.width = 100}, {.measured = true}),
                     other = network_image(flipped(picture), {.width = 100}, {.measured = true});
  const EdgeBlocks mirrored = measured_edges(batch_image(image, picture.size, true)),
                   drawn_flipped = measured_edges(batch_image(other, picture.size));
  REQUIRE(mirrored.weight.size() == drawn_flipped.weight.size());
  double tilt = 0;
  for (std::size_t i = 0; i < mirrored.weight.size(); ++i) {
    CHECK(mirrored.weight[i] == Approx(drawn_flipped.weight[i]).margin(.02));
    CHECK(mirrored.weighted_tilt[i] == Approx(drawn_flipped.weighted_tilt[i]).margin(.01));
    tilt += mirrored.weighted_tilt[i];
  }
  CHECK(tilt > 1);  // bars that lean to the right, tilt −.1, flipped
}

TEST_CASE("a correlated prior carries what edges say of one coefficient to the other") {
  LensPrior prior = wide_prior(wide_frame);
  FitMatrix covariance = prior.precision.inverse();
  covariance(1, 2) = covariance(2, 1) = -.9 * std::sqrt(covariance(1, 1) * covariance(2, 2));
  prior.precision = covariance.inverse();
  FitVector truth = prior.mean;
  truth[1] -= .1;
  truth[2] += .9 * .1 * std::sqrt(covariance(2, 2) / covariance(1, 1));
  const FrameEvidence frame = synthetic_evidence(prior, truth, wide_frame, 20, make_stream(3, "edges"));
  FrameEvidence independent = frame;
  independent.prior = wide_prior(wide_frame);
  const auto error = [&](const FrameEvidence& of) {
    return (fit_lens(of).parameters - truth).segment<2>(1).norm();
  };
  CHECK(error(frame) < error(independent));
}

TEST_CASE("the correlation is that of the targets and can be inverted") {
  std::vector<Outputs> targets;
  for (int i = 0; i < 4000; ++i) {
    const Stream stream = make_stream(i, "targets");
    Outputs target{1.2, random_normal(stream, 0), 0, random_normal(stream, 2), 0, 0, .5, .5};
    target[2] = -.8 * target[1] + .6 * random_normal(stream, 1);
    targets.push_back(target);
  }
  const OutputCovariance found = correlation(targets);
  // A correlation of r has a standard error of (1 − r²) / √n, at most .016 here.
  CHECK(found(1, 2) == Approx(-.8 * .99).margin(.03));
  CHECK(found(1, 3) == Approx(0).margin(.06));
  CHECK(found(0, 4) == 0);
  CHECK(found.diagonal() == Eigen::Matrix<double, 8, 1>::Ones());
  CHECK(std::isfinite(found.inverse().norm()));
}
