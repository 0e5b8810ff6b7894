#include "distortion/models/conversion/convert_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "distortion/models/conversion/parameter_jacobian.h"
#include "distortion/models/projection.h"
#include "numbers/infinity.h"

namespace cps {
namespace {

/// The variables of a fit with the intervals that they may not leave.
struct Variables {
  Eigen::VectorXd value, low, high;
};

int pinhole_count(const FreeVariables& free) {
  return free.pinhole ? 4 : 1;
}

/// Ends of the range of a family's parameter, those that lens_model.cpp checks; open ends lie just inside.
std::pair<double, double> range(std::string_view family, std::string_view parameter) {
  if (parameter == "xi" && family == "double_sphere") return {-1 + 1e-9, 1};
  if (parameter == "xi") return {0, 1e3};
  if (parameter == "alpha") return {0, 1};
  if (parameter == "beta") return {1e-6, 1e6};
  return {-infinity, infinity};
}

Variables variables_of(const ModelCamera& camera, const FreeVariables& free) {
  const auto size = pinhole_count(free) + static_cast<Eigen::Index>(free.parameters.size());
  Variables variables{.value = Eigen::VectorXd(size),
                      .low = Eigen::VectorXd::Constant(size, -infinity),
                      .high = Eigen::VectorXd::Constant(size, infinity)};
  const Pinhole& pinhole = camera.pinhole;
  if (free.pinhole)
    variables.value.head<4>() << pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy;
  else
    variables.value[0] = 1;
  variables.low.head(free.pinhole ? 2 : 1).setConstant(1e-6);
  const auto known = parameters(camera.lens);
  Eigen::Index next = pinhole_count(free);
  for (const int i : free.parameters) {
    variables.value[next] = known[i].second;
    std::tie(variables.low[next], variables.high[next]) = range(family_name(camera.lens), known[i].first);
    ++next;
  }
  return variables;
}

ModelCamera with_values(ModelCamera camera, const FreeVariables& free, const Eigen::VectorXd& values) {
  Pinhole& pinhole = camera.pinhole;
  if (free.pinhole) {
    pinhole.fx = values[0], pinhole.fy = values[1], pinhole.cx = values[2], pinhole.cy = values[3];
  } else {
    pinhole.fx *= values[0];
    pinhole.fy *= values[0];
  }
  const auto known = parameters(camera.lens);
  std::map<std::string, double> named(known.begin(), known.end());
  Eigen::Index next = pinhole_count(free);
  for (const int i : free.parameters) named[std::string(known[i].first)] = values[next++];
  camera.lens = lens_from_parameters(family_name(camera.lens), named);
  return camera;
}

/// Reprojection errors, and their derivatives by the variables; `start` is the camera that a scale refers to.
struct Linearisation {
  Eigen::VectorXd errors;
  Eigen::MatrixXd jacobian;
};

Linearisation linearised(const ModelCamera& camera, const Pinhole& start, const SeenRays& seen,
                         const FreeVariables& free) {
  const Pinhole& pinhole = camera.pinhole;
  const Eigen::Index rays = seen.rays.cols(), first = pinhole_count(free),
                     columns = first + static_cast<Eigen::Index>(free.parameters.size());
  Linearisation result{.errors = Eigen::VectorXd(2 * rays),
                       .jacobian = Eigen::MatrixXd::Zero(2 * rays, columns)};
  const Eigen::Vector2d focal(pinhole.fx, pinhole.fy);
  for (Eigen::Index i = 0; i < rays; ++i) {
    const Eigen::Vector2d point = project(camera.lens, seen.rays.col(i)).point;
    const ParameterJacobian by_parameters = parameter_jacobian(camera.lens, seen.rays.col(i));
    result.errors.segment<2>(2 * i) = to_pixel(pinhole, point) - seen.pixels.col(i);
    auto rows = result.jacobian.middleRows<2>(2 * i);
    if (free.pinhole)
      rows.leftCols<4>() << point.x(), 0, 1, 0, 0, point.y(), 0, 1;
    else
      rows.col(0) << start.fx * point.x(), start.fy * point.y();
    for (std::size_t k = 0; k < free.parameters.size(); ++k)
      rows.col(first + k) = focal.cwiseProduct(by_parameters.col(free.parameters[k]));
  }
  return result;
}

/// The damped steps that one linearisation gives. The columns are scaled to length 1 first, since raw
/// coefficients differ by orders of magnitude between narrow and wide cameras.
class DampedSteps {
 public:
  DampedSteps(const Linearisation& at, const Variables& variables) : size_(variables.value.size()) {
    const Eigen::VectorXd slopes = at.jacobian.transpose() * at.errors;
    for (Eigen::Index i = 0; i < size_; ++i) {
      const bool leaves_range = (variables.value[i] <= variables.low[i] && slopes[i] > 0) ||
                                (variables.value[i] >= variables.high[i] && slopes[i] < 0);
      if (!leaves_range && at.jacobian.col(i).squaredNorm() > 0) moving_.push_back(i);
    }
    const Eigen::Index count = moving();
    if (count == 0) return;
    const Eigen::MatrixXd columns = at.jacobian(Eigen::all, moving_);
    lengths_ = columns.colwise().norm();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns * lengths_.cwiseInverse().asDiagonal());
    triangle_ = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
    target_ = (qr.householderQ().adjoint() * -at.errors).head(count);
  }

  Eigen::Index moving() const { return static_cast<Eigen::Index>(moving_.size()); }

  /// The change of all variables that minimises |J step + errors|² + damping · |step|² in scaled variables.
  Eigen::VectorXd step(double damping) const {
    const Eigen::Index count = moving();
    Eigen::MatrixXd damped(2 * count, count);
    damped << triangle_, std::sqrt(damping) * Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd target = Eigen::VectorXd::Zero(2 * count);
    target.head(count) = target_;
    const Eigen::VectorXd scaled = damped.colPivHouseholderQr().solve(target);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(size_);
    step(moving_) = scaled.cwiseQuotient(lengths_);
    return step;
  }

 private:
  Eigen::Index size_;
  std::vector<Eigen::Index> moving_;
  Eigen::VectorXd lengths_, target_;
  Eigen::MatrixXd triangle_;
};

}  // namespace

double squared_error_px2(const ModelCamera& camera, const SeenRays& seen) {
  if (!(seen.max_angle_rad < angle_limit(camera.lens))) return infinity;
  const double sum = std::visit(
      [&](const auto& lens) {
        double sum = 0;
        for (Eigen::Index i = 0; i < seen.rays.cols(); ++i)
          sum += (to_pixel(camera.pinhole, project(lens, Eigen::Vector3d(seen.rays.col(i))).point) -
                  seen.pixels.col(i))
                     .squaredNorm();
        return sum;
      },
      camera.lens);
  return std::isfinite(sum) ? sum : infinity;
}

ModelCamera fitted(const ModelCamera& start, const SeenRays& seen, const FreeVariables& free) {
  constexpr int max_steps = 200;
  constexpr double max_damping = 1e12, smallest_gain = 1e-14;
  Variables variables = variables_of(start, free);
  ModelCamera best = start;
  double error = squared_error_px2(best, seen), damping = 1e-3;
  for (int count = 0; count < max_steps; ++count) {
    const DampedSteps steps(linearised(best, start.pinhole, seen, free), variables);
    if (steps.moving() == 0) break;
    const double before = error;
    for (; error == before && damping < max_damping; damping = std::max(10 * damping, 1e-12)) {
      const Eigen::VectorXd values =
          (variables.value + steps.step(damping)).cwiseMax(variables.low).cwiseMin(variables.high);
      if (!values.allFinite()) continue;
      const ModelCamera trial = with_values(start, free, values);
      const double trial_error = squared_error_px2(trial, seen);
      if (!(trial_error < error)) continue;
      variables.value = values;
      best = trial;
      error = trial_error;
    }
    if (!(before - error > smallest_gain * before)) break;
    damping /= 100;  // the loop multiplied it once more after the step that was taken
  }
  return best;
}

}  // namespace cps
