#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

namespace cps {

/// What the sky looks like, apart from the sun's disc.
enum class SkyModel {
  clear,     ///< computed from the sun's position and the turbidity
  overcast,  ///< the CIE standard overcast sky, white and as bright as clouds are; hides the sun
  constant,  ///< the same radiance from all directions, below the horizon too
  image      ///< an equirectangular picture of linear radiance (.hdr, .exr)
};

/// Sun and sky of one condition.
struct Daylight {
  double sun_elevation_deg = 40;  ///< above the horizon; below 0 only a clear sky gives light
  double sun_azimuth_deg = 135;   ///< clockwise from north seen from above; north is world −z, east +x
  double sun_angular_diameter_deg = 0.53;
  double turbidity = 3;  ///< 2 is very clear, 3 clear, 6 hazy (Preetham, Shirley & Smits 1999)

  SkyModel sky = SkyModel::clear;
  Eigen::Vector3f sky_radiance = {1, 1, 1};  ///< of a constant sky: kcd/m², linear Rec. 709
  std::filesystem::path sky_image = {};      ///< middle row: horizon; columns run clockwise
  double sky_image_azimuth_deg = 0;          ///< of its middle column, clockwise from north
  double sky_image_scale = 1;                ///< kcd/m² per unit of the image

  /// Sun light on a surface that faces the sun: klx, linear Rec. 709; 0 means no sun. If unset, a clear sky
  /// uses the atmosphere's model and the other skies have no sun.
  std::optional<Eigen::Vector3f> sun_irradiance_klx = std::nullopt;

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// Unit vector from the world to the sun (y up).
Eigen::Vector3f direction_to_sun(const Daylight& daylight);

}  // namespace cps
