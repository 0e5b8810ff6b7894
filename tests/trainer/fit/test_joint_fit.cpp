#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/quantile.h"
#include "tests/trainer/fit/drive.h"
#include "trainer/fit/joint_fit.h"
#include "trainer/fit/robust_weights.h"

using namespace cps;

TEST_CASE("frames joined without their angles say what the whole system of equations says") {
  constexpr int frames = 3, angles = fit_parameter_count - output_count,
                unknowns = output_count + frames * angles;
  const FitVector camera = drawn_camera(make_stream(1, "camera"));
  std::vector<WeighedFrame> weighed;
  for (const FrameEvidence& frame : drive(camera, frames, make_stream(1, "drive")))
    weighed.push_back({frame, .4 + .3 * static_cast<double>(weighed.size())});
  const JointFit fit = fit_jointly(weighed, std::vector<FitVector>(frames, camera), 20);

  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(unknowns);
  for (int i = 0; i < frames; ++i) {
    const bool has_same_outputs =
        fit.parameters[i].head<output_count>() == fit.parameters[0].head<output_count>();
    CHECK(has_same_outputs);
    const EdgeEquations equations = frame_equations(weighed[i].evidence, fit.parameters[i]);
    const auto unknown = [&](int k) { return k < output_count ? k : k + i * angles; };
    for (int k = 0; k < fit_parameter_count; ++k) {
      pull[unknown(k)] += weighed[i].weight * equations.pull[k];
      for (int l = 0; l < fit_parameter_count; ++l)
        information(unknown(k), unknown(l)) += weighed[i].weight * equations.information(k, l);
    }
  }
  const Eigen::MatrixXd covariance = information.inverse();
  const OutputCovariance joint = fit.information.inverse();
  CHECK((covariance.topLeftCorner(output_count, output_count) - joint).norm() < 1e-9 * joint.norm());
  // The gradient vanishes: one more step is below a hundredth of the deviations.
  CHECK(pull.dot(covariance * pull) < 1e-4);
}

TEST_CASE("a Student weight is 1 for what lies near and falls with the squared distance") {
  CHECK(student_weight(0, 8, 4) == 1);
  CHECK(student_weight(8, 8, 4) == 1);
  CHECK(student_weight(20, 8, 4) == Approx(.5));
  CHECK(student_weight(96, 1, 4) == Approx(.05));
}

TEST_CASE("a robust deviation is that of most values") {
  CHECK(quantile({3, 1, 2}, .5) == 2);
  CHECK(quantile({4, 1, 3, 2}, .5) == 2.5);
  CHECK(quantile({7}, .5) == 7);
  // The deviation of 4000 normal numbers by their median has a standard error of 1.8 %.
  std::vector<double> values;
  for (int i = 0; i < 4000; ++i) values.push_back(3 * random_normal(make_stream(1, "values"), i));
  CHECK(robust_deviation(values) == Approx(3).epsilon(.06));
  for (int i = 0; i < 400; ++i) values[i] = 1e6;
  CHECK(robust_deviation(values) == Approx(3).epsilon(.25));
}

TEST_CASE("weights of blocks follow the residuals of their tilts") {
  const FitVector camera = drawn_camera(make_stream(6, "camera"));
  FrameEvidence frame = exact_drive(camera, 1, 400).front();
  const auto known = [&](std::size_t i) { return frame.edges.weight[i] > 0; };
  std::size_t wild = 0;
  while (!known(wild)) ++wild;
  frame.edges.weighted_tilt[wild] += 10 * std::sqrt(frame.edges.weight[wild]);  // ten deviations
  const std::vector<double> residuals = tilt_residuals(frame, camera);
  const FrameEvidence before = frame;
  weigh_down(frame.edges, residuals, 2, 4);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!(before.edges.weight[i] > 0)) {
      CHECK(std::isnan(residuals[i]));
      CHECK(frame.edges.weight[i] == before.edges.weight[i]);
      continue;
    }
    CHECK(residuals[i] == Approx(i == wild ? 10 : 0).margin(.01));
    const double factor = i == wild ? 5. / (4 + 25) : 1;
    CHECK(frame.edges.weight[i] == Approx(factor * before.edges.weight[i]).epsilon(1e-3));
    CHECK(frame.edges.weighted_tilt[i] == Approx(factor * before.edges.weighted_tilt[i]).epsilon(1e-3));
  }
}
