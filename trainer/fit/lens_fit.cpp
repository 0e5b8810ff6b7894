#include "trainer/fit/lens_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "trainer/fit/edge_model.h"

namespace cps {
namespace {

/// Half the squared distance from the prior's mean, in its deviations.
double prior_cost(const LensPrior& prior, const FitVector& parameters) {
  const FitVector off = parameters - prior.mean;
  return .5 * off.dot(prior.precision * off);
}

FitVector within_bounds(FitVector parameters) {
  parameters[0] = std::clamp(parameters[0], fitted_hfov_rad.low, fitted_hfov_rad.high);
  return parameters;
}

/// Everything at one set of parameters.
struct Position {
  FitVector parameters;
  TiltModel model;
  EdgeEquations edges;
  double cost = 0;
};

Position position_at(const FrameEvidence& frame, const FitVector& parameters) {
  Position position{parameters, tilt_model(frame, parameters), {}, 0};
  position.edges = edge_equations(frame, position.model);
  position.cost = position.edges.cost + prior_cost(frame.prior, parameters);
  return position;
}

FitMatrix information_at(const FrameEvidence& frame, const Position& position) {
  return position.edges.information + frame.prior.precision;
}

}  // namespace

TiltModel tilt_model(const FrameEvidence& frame, const FitVector& parameters) {
  const StreetCamera camera = street_camera(parameters, frame.edges.picture);
  const ImageSize& grid = frame.edges.grid;
  const std::size_t blocks = static_cast<std::size_t>(grid.width) * grid.height;
  TiltModel model{std::vector<double>(edge_families * blocks),
                  std::vector<double>(edge_families * blocks * fit_parameter_count),
                  std::vector<bool>(edge_families * blocks)};
  std::size_t block = 0;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column, ++block) {
      if (frame.edges.weight[block] + frame.edges.weight[blocks + block] <= 0) continue;
      const auto tilts = edge_tilts(camera, frame.centres.x[column], frame.centres.y[row]);
      for (int family = 0; family < edge_families; ++family) {
        if (!tilts[family]) continue;
        const std::size_t i = family * blocks + block;
        model.has_tilt[i] = true;
        model.tilt[i] = tilts[family]->tilt;
        FitVector::Map(&model.slope[i * fit_parameter_count]) = tilts[family]->slope;
      }
    }
  return model;
}

EdgeEquations edge_equations(const FrameEvidence& frame, const TiltModel& model) {
  EdgeEquations sums;
  for (std::size_t i = 0; i < model.tilt.size(); ++i) {
    const double weight = frame.edges.weight[i], weighted_tilt = frame.edges.weighted_tilt[i];
    if (!model.has_tilt[i]) {
      sums.cost += .5 * weight + std::abs(weighted_tilt);
      continue;
    }
    const auto slope = FitVector::Map(&model.slope[i * fit_parameter_count]);
    sums.information.noalias() += weight * slope * slope.transpose();
    sums.pull += (weighted_tilt - weight * model.tilt[i]) * slope;
    sums.cost += model.tilt[i] * (.5 * weight * model.tilt[i] - weighted_tilt);
  }
  return sums;
}

LensFit fit_lens(const FrameEvidence& frame, int max_iterations) {
  Position at = position_at(frame, within_bounds(frame.prior.mean));
  LensFit fit;
  for (; fit.iterations < max_iterations; ++fit.iterations) {
    const FitVector pull = at.edges.pull - frame.prior.precision * (at.parameters - frame.prior.mean);
    const Eigen::LLT<FitMatrix> factor(information_at(frame, at));
    const FitVector step = factor.solve(pull);
    constexpr double small_share = 1e-6;  // of the squared deviations: step · information · step
    if (step.dot(pull) < small_share) break;
    bool is_lower = false;
    double length = 1;
    for (int halvings = 0; halvings < 5 && !is_lower; ++halvings, length /= 2) {
      Position next = position_at(frame, within_bounds(at.parameters + length * step));
      is_lower = next.cost < at.cost;
      if (is_lower) at = std::move(next);
    }
    if (!is_lower) break;
  }
  fit.information = information_at(frame, at);
  fit.parameters = at.parameters;
  fit.model = std::move(at.model);
  return fit;
}

}  // namespace cps
