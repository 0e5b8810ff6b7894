#include "trainer/fit/lens_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "trainer/fit/edge_model.h"
#include "trainer/fit/line_search.h"

namespace cps {
namespace {

/// Everything at one set of parameters.
struct Position {
  FitVector parameters;
  TiltModel model;
  EdgeEquations equations;
  double cost = 0;
};

Position position_at(const FrameEvidence& frame, const FitVector& parameters) {
  Position position{parameters, tilt_model(frame, parameters), {}, 0};
  position.equations = frame_equations(frame, parameters, position.model);
  position.cost = position.equations.cost;
  return position;
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

EdgeEquations frame_equations(const FrameEvidence& frame, const FitVector& parameters,
                              const TiltModel& model) {
  EdgeEquations equations = edge_equations(frame, model);
  const FitVector off = parameters - frame.prior.mean, prior_pull = frame.prior.precision * off;
  equations.information += frame.prior.precision;
  equations.pull -= prior_pull;
  equations.cost += .5 * off.dot(prior_pull);
  return equations;
}

EdgeEquations frame_equations(const FrameEvidence& frame, const FitVector& parameters) {
  return frame_equations(frame, parameters, tilt_model(frame, parameters));
}

FitVector within_bounds(FitVector parameters) {
  parameters[0] = std::clamp(parameters[0], fitted_hfov_rad.low, fitted_hfov_rad.high);
  return parameters;
}

LensFit fit_lens(const FrameEvidence& frame, int max_iterations) {
  Position at = position_at(frame, within_bounds(frame.prior.mean));
  LensFit fit;
  for (; fit.iterations < max_iterations; ++fit.iterations) {
    const FitVector& pull = at.equations.pull;
    const FitVector step = Eigen::LLT<FitMatrix>(at.equations.information).solve(pull);
    constexpr double small_share = 1e-6;  // of the squared deviations: step · information · step
    if (step.dot(pull) < small_share) break;
    const auto along = [&](double length) {
      return position_at(frame, within_bounds(at.parameters + length * step));
    };
    if (!take_lower(at, along)) break;
  }
  fit.information = at.equations.information;
  fit.parameters = at.parameters;
  fit.model = std::move(at.model);
  return fit;
}

}  // namespace cps
