#include "distortion/models/conversion/convert_start.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <optional>

#include "distortion/models/projection.h"

namespace cps {
namespace {

std::optional<double> value_of(const HeldParameters& held, const std::string& name) {
  const auto found = held.find(name);
  return found == held.end() ? std::nullopt : std::optional(found->second);
}

std::vector<double> even_steps(double first, double last, int count) {
  std::vector<double> list;
  for (int i = 0; i < count; ++i) list.push_back(first + (last - first) * i / (count - 1));
  return list;
}

/// scale · q (1 + a1 q² + a2 q⁴ + …) / (1 + b1 q² + …) = radius, with a_i named k1, k2, … and the b_i the
/// numbers behind them: linear in scale, scale · a_i and b_i.
std::optional<FitStart> polynomial_start(std::string_view family, const RadialProfile& profile,
                                         const Eigen::ArrayXd& q, int numerators, int denominators,
                                         HeldParameters values) {
  struct Term {
    std::string name;
    bool is_numerator;
    Eigen::ArrayXd column;
  };
  Eigen::ArrayXd base = q, target = profile.radius;
  std::vector<Term> free;
  for (int i = 1; i <= numerators + denominators; ++i) {
    Term term{.name = "k" + std::to_string(i), .is_numerator = i <= numerators, .column = {}};
    const Eigen::ArrayXd power = q.pow(2 * (term.is_numerator ? i : i - numerators));
    if (term.is_numerator)
      term.column = q * power;
    else
      term.column = -profile.radius * power;
    const auto known = value_of(values, term.name);
    if (!known)
      free.push_back(term);
    else if (term.is_numerator)
      base += *known * term.column;
    else
      target -= *known * term.column;
  }
  Eigen::MatrixXd columns(q.size(), 1 + free.size());
  columns.col(0) = base;
  for (std::size_t i = 0; i < free.size(); ++i) columns.col(i + 1) = free[i].column;
  // Powers of a narrow camera's q differ by many orders of magnitude.
  const Eigen::VectorXd lengths = columns.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  const Eigen::VectorXd found = (columns * lengths.cwiseInverse().asDiagonal())
                                    .colPivHouseholderQr()
                                    .solve(target.matrix())
                                    .cwiseQuotient(lengths);
  const double scale = found[0];
  if (!(scale > 0) || !found.allFinite()) return {};
  for (std::size_t i = 0; i < free.size(); ++i)
    values[free[i].name] = free[i].is_numerator ? found[i + 1] / scale : found[i + 1];
  return FitStart{scale, lens_from_parameters(family, values)};
}

/// The α with the smallest error for fixed other parameters; the scale follows by least squares.
std::optional<FitStart> alpha_start(std::string_view family, const RadialProfile& profile,
                                    HeldParameters values) {
  std::optional<FitStart> best;
  double smallest = std::numeric_limits<double>::infinity();
  const auto held = value_of(values, "alpha");
  for (const double alpha : held ? std::vector{*held} : even_steps(0, 1, 21)) {
    values["alpha"] = alpha;
    const LensModel lens = lens_from_parameters(family, values);
    if (!(profile.angle_rad.maxCoeff() < angle_limit(lens))) continue;
    Eigen::ArrayXd radius(profile.angle_rad.size());
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
      const double angle = profile.angle_rad[i];
      radius[i] = project(lens, {std::sin(angle), 0, std::cos(angle)}).point.x();
    }
    const double scale = (radius * profile.radius).sum() / radius.square().sum();
    const double error = (scale * radius - profile.radius).square().sum();
    if (!(scale > 0 && error < smallest)) continue;
    smallest = error;
    best = FitStart{scale, lens};
  }
  return best;
}

}  // namespace

std::optional<ShapeParameter> shape_parameter(std::string_view family) {
  if (family == "unified_spherical")
    return ShapeParameter{
        "xi", {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.5, 2, 3, 5, 10, 30, 100}};
  if (family == "double_sphere") return ShapeParameter{"xi", even_steps(-0.9, 1, 20)};
  if (family != "eucm") return {};
  ShapeParameter beta{"beta", even_steps(-3, 3, 25)};
  for (double& value : beta.values) value = std::exp(value);
  return beta;
}

std::optional<FitStart> fit_start(std::string_view family, const RadialProfile& profile,
                                  const HeldParameters& held) {
  const Eigen::ArrayXd& angle = profile.angle_rad;
  std::optional<FitStart> start;
  if (family == "brown_conrady")
    start = polynomial_start(family, profile, angle.tan(), 3, 0, held);
  else if (family == "rational")
    start = polynomial_start(family, profile, angle.tan(), 3, 3, held);
  else if (family == "kannala_brandt")
    start = polynomial_start(family, profile, angle, 4, 0, held);
  else if (family == "unified_spherical")
    start = polynomial_start(family, profile, angle.sin() / (angle.cos() + held.at("xi")), 3, 0, held);
  else
    start = alpha_start(family, profile, held);
  if (start && !(angle.maxCoeff() < angle_limit(start->lens))) return {};
  return start;
}

}  // namespace cps
