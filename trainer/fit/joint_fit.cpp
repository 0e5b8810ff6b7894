#include "trainer/fit/joint_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <utility>

#include "trainer/fit/line_search.h"

namespace cps {
namespace {

constexpr int angle_count = fit_parameter_count - output_count;

/// A frame's angles follow the outputs: step of the angles = to_pull − to_outputs · step of the outputs.
struct AngleResponse {
  Eigen::Matrix<double, angle_count, 1> to_pull;
  Eigen::Matrix<double, angle_count, output_count> to_outputs;
};

AngleResponse angle_response(const EdgeEquations& frame) {
  const Eigen::LLT<Eigen::Matrix<double, angle_count, angle_count>> factor(
      frame.information.bottomRightCorner<angle_count, angle_count>());
  return {factor.solve(frame.pull.tail<angle_count>()),
          factor.solve(frame.information.bottomLeftCorner<angle_count, output_count>())};
}

/// All frames at some parameters.
struct JointPosition {
  std::vector<FitVector> parameters;
  std::vector<EdgeEquations> equations;  ///< of each frame, without its weight
  double cost = 0;
};

JointPosition joint_position(std::span<const WeighedFrame> frames, std::vector<FitVector> parameters) {
  JointPosition at{std::move(parameters), std::vector<EdgeEquations>(frames.size()), 0};
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    at.equations[i] = frame_equations(frames[i].evidence, at.parameters[i]);
  });
  for (std::size_t i = 0; i < frames.size(); ++i) at.cost += frames[i].weight * at.equations[i].cost;
  return at;
}

OutputEquations joint_equations(std::span<const WeighedFrame> frames, const JointPosition& at) {
  OutputEquations sum;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const OutputEquations one = without_angles(at.equations[i]);
    sum.information += frames[i].weight * one.information;
    sum.pull += frames[i].weight * one.pull;
  }
  return sum;
}

struct JointStep {
  std::vector<FitVector> of_frames;
  double squared_length = 0;  ///< in standard deviations
};

JointStep joint_step(std::span<const WeighedFrame> frames, const JointPosition& at) {
  const OutputEquations sum = joint_equations(frames, at);
  const OutputVector outputs = Eigen::LLT<OutputCovariance>(sum.information).solve(sum.pull);
  JointStep step{std::vector<FitVector>(frames.size()), outputs.dot(sum.pull)};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const AngleResponse response = angle_response(at.equations[i]);
    step.of_frames[i].head<output_count>() = outputs;
    step.of_frames[i].tail<angle_count>() = response.to_pull - response.to_outputs * outputs;
    step.squared_length += frames[i].weight * at.equations[i].pull.tail<angle_count>().dot(response.to_pull);
  }
  return step;
}

std::vector<FitVector> moved(std::vector<FitVector> parameters, const JointStep& step, double length) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = within_bounds(parameters[i] + length * step.of_frames[i]);
  return parameters;
}

}  // namespace

OutputEquations without_angles(const EdgeEquations& frame) {
  const AngleResponse response = angle_response(frame);
  const auto across = frame.information.topRightCorner<output_count, angle_count>();
  return {frame.information.topLeftCorner<output_count, output_count>() - across * response.to_outputs,
          frame.pull.head<output_count>() - across * response.to_pull};
}

JointFit fit_jointly(std::span<const WeighedFrame> frames, std::vector<FitVector> start, int max_iterations) {
  JointPosition at = joint_position(frames, std::move(start));
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const JointStep step = joint_step(frames, at);
    constexpr double small_step = 1e-4;
    if (step.squared_length < small_step) break;
    const auto along = [&](double length) {
      return joint_position(frames, moved(at.parameters, step, length));
    };
    if (!take_lower(at, along)) break;
  }
  const OutputCovariance information = joint_equations(frames, at).information;
  return {std::move(at.parameters), information};
}

}  // namespace cps
