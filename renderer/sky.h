#pragma once

#include <vector>

#include "renderer/direction_table.h"
#include "scenes/daylight.h"

namespace cps {

/// All light from beyond the scene but the sun's disc: the computed sky, and below the horizon a lit, hazy
/// plain.
struct Sky {
  int columns = 0, rows = 0;
  std::vector<Eigen::Array4f>
      radiance_table;  ///< at the cells' middles, kcd/m²; the fourth number is padding
  DirectionDistribution distribution;

  Color radiance(const Vec3& direction) const;
};

/// The sun's disc, uniformly bright.
struct Sun {
  Vec3 direction;  ///< from the world to its centre
  Color radiance;  ///< kcd/m²; 0 once it has set
  float chord2;    ///< squared chord of its angular radius on the unit sphere; the disc covers π·chord² sr
  float pdf;       ///< of every direction in the disc, 1/sr

  bool shines() const { return (radiance > 0.0f).any(); }
  bool covers(const Vec3& from_world) const { return (from_world - direction).squaredNorm() <= chord2; }
  Vec3 sample(const Eigen::Vector2f& u) const;
};

struct SkyAndSun {
  Sky sky;
  Sun sun;
};

/// Sun and sky of a clear day, in proportion (see Atmosphere).
SkyAndSun make_clear_day(const Daylight& daylight);

/// The same radiance from everywhere.
Sky make_constant_sky(const Color& radiance);

Sun make_sun(const Vec3& direction, double angular_diameter_rad, const Color& irradiance);

}  // namespace cps
