#pragma once

#include "renderer/math/frame.h"

namespace cps {

/// The sun's disc, uniformly bright.
struct Sun {
  Vec3 direction;  ///< from the world to its centre
  Frame frame;     ///< around it
  Color radiance;  ///< kcd/m²; 0 once it has set
  float chord2;    ///< squared chord of its angular radius on the unit sphere; the disc covers π·chord² sr
  float pdf;       ///< of every direction in the disc, 1/sr

  bool shines() const { return (radiance > 0.0f).any(); }
  /// Whether a ray in this direction meets the disc.
  bool covers(const Vec3& from_world) const { return (from_world - direction).squaredNorm() <= chord2; }
  /// A direction drawn uniformly from the disc, for `u` uniform in [0, 1)².
  Vec3 sample(const Eigen::Vector2f& u) const;
};

/// `irradiance`: of a surface that faces the sun, klx.
Sun make_sun(const Vec3& direction, double angular_diameter_rad, const Color& irradiance);

}  // namespace cps
