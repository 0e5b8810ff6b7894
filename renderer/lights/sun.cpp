#include "renderer/lights/sun.h"

#include <cmath>
#include <numbers>

#include "renderer/math/fast_math.h"

namespace cps {

Vec3 Sun::sample(const Eigen::Vector2f& u) const {
  const float chord2_here = u.y() * chord2;
  const SinCos azimuth = sincos_of_turns(u.x());
  const float sine = std::sqrt(chord2_here * (1.0f - 0.25f * chord2_here));
  return frame.to_world({sine * azimuth.cos, sine * azimuth.sin, 1.0f - 0.5f * chord2_here});
}

Sun make_sun(const Vec3& direction, double angular_diameter_rad, const Color& irradiance) {
  Sun sun;
  sun.direction = direction;
  sun.frame = frame_around(direction);
  const double chord = 2.0 * std::sin(0.25 * angular_diameter_rad);
  sun.chord2 = static_cast<float>(chord * chord);
  sun.pdf = static_cast<float>(1.0 / (std::numbers::pi * chord * chord));
  sun.radiance = irradiance * sun.pdf;
  return sun;
}

}  // namespace cps
