#pragma once

#include <vector>

#include "renderer/lights/direction_table.h"
#include "scenes/daylight.h"

namespace cps {

/// All light from beyond the scene but the sun's disc, as a table of radiance.
struct Sky {
  int columns = 0, rows = 0;
  Rows spacing = Rows::crowded_at_horizon;
  std::vector<Eigen::Array4f>
      radiance_table;  ///< at the cells' middles, kcd/m²; the fourth number is padding
  /// Directions to draw light from, beside those that a BSDF draws: by how much they are brighter than the
  /// sky is on average (see make_sky_distribution). Empty for a constant sky.
  DirectionDistribution distribution;

  Color radiance(const Vec3& direction) const;
};

/// A dark sky of so many cells, and the radiance of one of them.
Sky make_empty_sky(int columns, int rows, Rows spacing);
void set_cell(Sky& sky, int column, int row, const Color& radiance);

/// Direction of the middle of a cell.
Vec3 cell_direction(const Sky& sky, int column, int row);

/// What the upper half of the sky sends to level ground, klx.
Color horizontal_irradiance(const Sky& sky);

/// Importance for a sky that BSDF samples find as well: its mean luminance is left to them and only what
/// exceeds it is drawn here, which takes noise from the sum of both (Karlík et al. 2019, "MIS compensation").
/// To be called once the table is filled.
DirectionDistribution make_sky_distribution(const Sky& sky);

/// The same radiance from everywhere.
Sky make_constant_sky(const Color& radiance);

}  // namespace cps
