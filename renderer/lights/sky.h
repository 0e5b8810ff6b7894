#pragma once

#include <vector>

#include "renderer/lights/direction_table.h"
#include "scenes/daylight.h"

namespace cps {

/// Light from beyond the scene except the sun's disc, as a table of radiance.
struct Sky {
  int columns = 0, rows = 0;
  Rows spacing = Rows::crowded_at_horizon;
  std::vector<Eigen::Array4f>
      radiance_table;  ///< at the cells' middles, kcd/m²; the fourth number is padding
  /// Draws directions in addition to those that BSDFs draw, by how much they are brighter than the mean of
  /// the sky (see make_sky_distribution). Empty for a constant sky.
  DirectionDistribution distribution;

  Color radiance(const Vec3& direction) const;
};

/// A black sky of this many cells.
Sky make_empty_sky(int columns, int rows, Rows spacing);

/// Sets the radiance of one cell.
void set_cell(Sky& sky, int column, int row, const Color& radiance);

/// Direction of the middle of a cell.
Vec3 cell_direction(const Sky& sky, int column, int row);

/// Illuminance of level ground by the upper half of the sky, klx, linear Rec. 709.
Color horizontal_irradiance(const Sky& sky);

/// Distribution of light samples for a sky. Only luminance above the sky's mean is drawn; the rest is left to
/// BSDF samples, which lowers the noise of the sum of both (Karlík et al. 2019, "MIS compensation"). The
/// table must be filled.
DirectionDistribution make_sky_distribution(const Sky& sky);

/// A sky of the same radiance everywhere.
Sky make_constant_sky(const Color& radiance);

}  // namespace cps
