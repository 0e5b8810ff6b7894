#include "distortion/models/conversion/parameter_jacobian.h"

#include <cmath>

#include "distortion/models/projection.h"

namespace cps {
namespace {

/// k1, k2, k3, p1, p2 at an ideal point of the plane, in which Brown–Conrady is linear.
Eigen::Matrix<double, 2, 5> coefficient_jacobian(const Eigen::Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y(), s = ideal.squaredNorm();
  Eigen::Matrix<double, 2, 5> result;
  result << x * s, x * s * s, x * s * s * s, 2 * x * y, s + 2 * x * x,  //
      y * s, y * s * s, y * s * s * s, s + 2 * y * y, 2 * x * y;
  return result;
}

ParameterJacobian jacobian(const Distortion&, const Eigen::Vector3d& ray) {
  return coefficient_jacobian(ray.hnormalized());
}

ParameterJacobian jacobian(const RationalLens& lens, const Eigen::Vector3d& ray) {
  const Eigen::Vector2d ideal = ray.hnormalized();
  const double s = ideal.squaredNorm();
  const double numerator = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
  const double denominator = 1 + s * (lens.k4 + s * (lens.k5 + s * lens.k6));
  const Eigen::Matrix<double, 2, 5> plane = coefficient_jacobian(ideal);
  ParameterJacobian result(2, 8);
  result << plane.leftCols<3>() / denominator, -numerator / (denominator * denominator) * plane.leftCols<3>(),
      plane.rightCols<2>();
  return result;
}

ParameterJacobian jacobian(const KannalaBrandt&, const Eigen::Vector3d& ray) {
  const double across = ray.head<2>().norm(), angle = std::atan2(across, ray.z()), square = angle * angle;
  ParameterJacobian result = ParameterJacobian::Zero(2, 4);
  if (across == 0) return result;
  Eigen::Vector2d term = angle / across * ray.head<2>();
  for (int i = 0; i < 4; ++i) result.col(i) = term *= square;
  return result;
}

ParameterJacobian jacobian(const UnifiedSpherical& lens, const Eigen::Vector3d& ray) {
  const double shifted = ray.z() / ray.norm() + lens.xi;
  const Eigen::Vector2d on_plane = ray.head<2>() / (ray.norm() * shifted);
  ParameterJacobian result(2, 6);
  result << distortion_jacobian(lens.distortion, on_plane) * (-on_plane / shifted),
      coefficient_jacobian(on_plane);
  return result;
}

ParameterJacobian jacobian(const Eucm& lens, const Eigen::Vector3d& ray) {
  const double across2 = ray.head<2>().squaredNorm(), z = ray.z();
  const double rho = std::sqrt(lens.beta * across2 + z * z);
  const double denominator = lens.alpha * rho + (1 - lens.alpha) * z;
  const Eigen::Vector2d shrinking = -ray.head<2>() / (denominator * denominator);
  ParameterJacobian result(2, 2);
  result << shrinking * (rho - z), shrinking * (lens.alpha * across2 / (2 * rho));
  return result;
}

ParameterJacobian jacobian(const DoubleSphere& lens, const Eigen::Vector3d& ray) {
  const double distance = ray.norm(), shifted = lens.xi * distance + ray.z();
  const double second = std::sqrt(ray.head<2>().squaredNorm() + shifted * shifted);
  const double denominator = lens.alpha * second + (1 - lens.alpha) * shifted;
  const Eigen::Vector2d shrinking = -ray.head<2>() / (denominator * denominator);
  ParameterJacobian result(2, 2);
  result << shrinking * (distance * (lens.alpha * shifted / second + 1 - lens.alpha)),
      shrinking * (second - shifted);
  return result;
}

}  // namespace

ParameterJacobian parameter_jacobian(const LensModel& lens, const Eigen::Vector3d& ray) {
  return std::visit([&](const auto& family) { return jacobian(family, ray); }, lens);
}

}  // namespace cps
