#include "trainer/fit/edge_model.h"

#include <Eigen/LU>
#include <cmath>

#include "trainer/calibration/seen_hfov.h"

namespace cps {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double max_tilt = .4;

/// Shortest image of a unit direction: nearer to its vanishing point, the direction of an edge says nothing.
constexpr double min_length = .05;

/// The smallest eigenvalue's least product with the other, below which a lens counts as folding.
constexpr double min_determinant = .02;

Matrix2d jacobian_of(const DistortedPoint& at) {
  return (Matrix2d() << at.xx, at.xy, at.xy, at.yy).finished();
}

/// The lens with one coefficient, 1.
constexpr std::array<Distortion, 5> unit_lenses{{{.k1 = 1}, {.k2 = 1}, {.k3 = 1}, {.p1 = 1}, {.p2 = 1}}};

/// The ideal point by Newton's method from the distorted one; empty if it does not get there.
std::optional<Vector2d> ideal_point(const Distortion& lens, const Vector2d& distorted) {
  Vector2d ideal = distorted;
  for (int i = 0; i < 12; ++i) {
    const DistortedPoint at = evaluate(lens, ideal.x(), ideal.y());
    const Matrix2d jacobian = jacobian_of(at);
    if (!(jacobian.determinant() > min_determinant && jacobian.trace() > 0)) return std::nullopt;
    const Vector2d step = jacobian.inverse() * (distorted - Vector2d(at.x, at.y));
    ideal += step;
    if (step.squaredNorm() < 1e-20) return ideal;
  }
  return std::nullopt;
}

/// A point of the picture with everything that does not depend on the family of edges.
struct LensPoint {
  Vector2d ideal;
  Matrix2d jacobian, jacobian_by_x, jacobian_by_y;  ///< of the lens, and its slopes along the ideal point
  std::array<Matrix2d, 5> jacobian_by_coefficient;  ///< at the fixed ideal point
  std::array<Vector2d, 5> ideal_by_coefficient;     ///< at the fixed picture point
  Matrix2d ideal_by_centre;                         ///< columns: by the principal point's X and Y
};

std::optional<LensPoint> lens_point(const Distortion& lens, const Vector2d& distorted) {
  const std::optional<Vector2d> ideal = ideal_point(lens, distorted);
  if (!ideal) return std::nullopt;
  LensPoint point;
  point.ideal = *ideal;
  const double x = ideal->x(), y = ideal->y();
  point.jacobian = jacobian_of(evaluate(lens, x, y));
  if (!(point.jacobian.determinant() > min_determinant)) return std::nullopt;
  const Matrix2d inverse = point.jacobian.inverse();
  constexpr double h = 1e-4;
  const auto slope = [&](double dx, double dy) -> Matrix2d {
    return (jacobian_of(evaluate(lens, x + dx, y + dy)) - jacobian_of(evaluate(lens, x - dx, y - dy))) /
           (2 * h);
  };
  point.jacobian_by_x = slope(h, 0);
  point.jacobian_by_y = slope(0, h);
  // The distorted point and its Jacobian are linear in the coefficients.
  for (int i = 0; i < 5; ++i) {
    const DistortedPoint unit = evaluate(unit_lenses[i], x, y);
    point.jacobian_by_coefficient[i] = jacobian_of(unit) - Matrix2d::Identity();
    point.ideal_by_coefficient[i] = -inverse * (Vector2d(unit.x, unit.y) - *ideal);
  }
  point.ideal_by_centre = -inverse;
  return point;
}

/// The image direction of an edge, and its slope by each parameter.
struct ImageDirection {
  Vector2d along;
  Eigen::Matrix<double, 2, fit_parameter_count> slopes;
};

ImageDirection image_direction(const StreetCamera& camera, const LensPoint& point,
                               const StreetCamera::Direction& edge) {
  const double r = camera.half_diagonal;
  const Vector3d& d = edge.along;
  // On the plane z = 1, at the point r·ideal, and divided by r.
  const Vector2d ideal_direction = d.head<2>() - r * d.z() * point.ideal;
  ImageDirection image{point.jacobian * ideal_direction, {}};
  image.slopes = -d.z() * point.jacobian * point.ideal * camera.half_diagonal_slope.transpose();
  const auto add_move = [&](int parameter, const Vector2d& of_ideal) {
    const Matrix2d turned = of_ideal.x() * point.jacobian_by_x + of_ideal.y() * point.jacobian_by_y;
    image.slopes.col(parameter) += turned * ideal_direction - r * d.z() * point.jacobian * of_ideal;
  };
  for (int i = 0; i < 5; ++i) {
    add_move(1 + i, point.ideal_by_coefficient[i]);
    image.slopes.col(1 + i) += point.jacobian_by_coefficient[i] * ideal_direction;
  }
  add_move(6, camera.cx_unit * point.ideal_by_centre.col(0));
  add_move(7, camera.cy_unit * point.ideal_by_centre.col(1));
  for (int i = 0; i < 3; ++i) {
    const Vector3d& turned = edge.slopes[i];
    image.slopes.col(pitch_parameter + i) +=
        point.jacobian * (turned.head<2>() - r * turned.z() * point.ideal);
  }
  return image;
}

/// Minus the steep component's quotient: `flat` 0 for near-vertical edges, 1 for near-horizontal ones.
std::optional<EdgeTilt> tilt_of(const ImageDirection& image, int flat) {
  const double across = image.along[flat], along = image.along[1 - flat];
  if (!(std::abs(across) < max_tilt * std::abs(along) && std::abs(along) > min_length)) return std::nullopt;
  const double tilt = -across / along;
  return EdgeTilt{tilt, -(image.slopes.row(flat) + tilt * image.slopes.row(1 - flat)).transpose() / along};
}

std::array<StreetCamera::Direction, edge_families> street_directions(double pitch, double roll, double yaw) {
  const double sp = std::sin(pitch), cp = std::cos(pitch), sr = std::sin(roll), cr = std::cos(roll),
               sy = std::sin(yaw), cy = std::cos(yaw);
  const Vector3d right(cr, -sr, 0), ahead(sp * sr, sp * cr, cp), up(-cp * sr, -cp * cr, sp), none(0, 0, 0);
  return {{{up, {ahead, -cp * right, none}},
           {cy * right + sy * ahead,
            {-sy * up, Vector3d(-cy * sr + sy * sp * cr, -cy * cr - sy * sp * sr, 0),
             -sy * right + cy * ahead}}}};
}

}  // namespace

StreetCamera street_camera(const FitVector& parameters, const ImageSize& picture) {
  Outputs outputs;
  for (int i = 0; i < output_count; ++i) outputs[i] = parameters[i];
  const double diagonal = std::hypot(picture.width, picture.height);
  StreetCamera camera;
  camera.lens = {outputs[1], outputs[2], outputs[3], outputs[4], outputs[5]};
  camera.cx_unit = 2 * picture.width / diagonal;
  camera.cy_unit = 2 * picture.height / diagonal;
  camera.cx = (2 * outputs[6] * picture.width + 1 - picture.width) / diagonal;
  camera.cy = (2 * outputs[7] * picture.height + 1 - picture.height) / diagonal;

  const IdealRadius edge = ideal_radius(outputs, half_width_share(picture.width, picture.height));
  const double tangent = std::tan(outputs[0] / 2), s = edge.radius * edge.radius;
  camera.half_diagonal = tangent / edge.radius;
  camera.half_diagonal_slope.setZero();
  camera.half_diagonal_slope[0] = (1 + tangent * tangent) / (2 * edge.radius);
  // Where the lens folds, or nearly, the radius is taken as fixed.
  constexpr double least_slope = .05;
  if (edge.slope > least_slope) {
    double power = s;  // of the radius, beside radius itself: ∂radius/∂k_i = −radius^(2i+1) / slope
    for (int i = 1; i <= 3; ++i, power *= s)
      camera.half_diagonal_slope[i] = camera.half_diagonal * power / edge.slope;
  }
  camera.directions =
      street_directions(parameters[pitch_parameter], parameters[roll_parameter], parameters[yaw_parameter]);
  return camera;
}

std::array<std::optional<EdgeTilt>, edge_families> edge_tilts(const StreetCamera& camera, double x,
                                                              double y) {
  const std::optional<LensPoint> point = lens_point(camera.lens, {x - camera.cx, y - camera.cy});
  if (!point) return {};
  return {tilt_of(image_direction(camera, *point, camera.directions[0]), 0),
          tilt_of(image_direction(camera, *point, camera.directions[1]), 1)};
}

}  // namespace cps
