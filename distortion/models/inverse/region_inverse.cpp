#include "distortion/models/inverse/region_inverse.h"

namespace cps {

Eigen::Vector3d radial_ray(const KannalaBrandt& lens, double max_angle_rad, const Eigen::Vector2d& point) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  // Newton's method has mostly arrived after six steps, but may go back and forth within the bracket for ever.
  constexpr int newton_steps = 20;
  const double radius = point.norm();
  double low = 0, high = max_angle_rad, angle = std::min(radius, max_angle_rad);
  for (int step = 0; step < 100; ++step) {
    const auto [per_angle, slope] = evaluate(lens, angle);
    const double error = angle * per_angle - radius;
    if (std::abs(error) <= epsilon * radius) break;
    (error < 0 ? low : high) = angle;
    const double newton = angle - error / slope;
    const double next = step < newton_steps && newton > low && newton < high ? newton : 0.5 * (low + high);
    const double moved = std::abs(next - angle);
    angle = next;
    if (moved <= epsilon * angle) break;
  }
  const auto [sine, cosine] = straight_sine_cosine(angle);
  const double scale = radius > 0 ? sine / radius : 0;
  return {scale * point.x(), scale * point.y(), cosine};
}

}  // namespace cps
