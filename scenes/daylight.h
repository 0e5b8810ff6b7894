#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

namespace cps {

/// What lights the scene from beyond but for the sun's disc.
enum class SkyModel {
  clear,     ///< computed from the sun's place and the turbidity
  overcast,  ///< the CIE's standard overcast sky, as bright and as white as clouds make it; hides the sun
  constant,  ///< the same radiance from everywhere, below the horizon too
  image      ///< an equirectangular picture of linear radiance (.hdr, .exr)
};

/// Sun and sky of one condition.
struct Daylight {
  double sun_elevation_deg = 40;  ///< above the horizon; below it only a clear sky still has light
  double sun_azimuth_deg = 135;   ///< clockwise from north seen from above; north is world −z, east +x
  double sun_angular_diameter_deg = 0.53;
  double turbidity = 3;  ///< 2 is very clear, 3 clear, 6 hazy (Preetham, Shirley & Smits 1999)

  SkyModel sky = SkyModel::clear;
  Eigen::Vector3f sky_radiance = {1, 1, 1};  ///< of a constant sky, kcd/m², linear Rec. 709
  std::filesystem::path sky_image = {};      ///< its middle row is the horizon, columns run clockwise
  double sky_image_azimuth_deg = 0;          ///< clockwise from north: where its middle column lies
  double sky_image_scale = 1;                ///< kcd/m² per unit of the picture

  /// On a surface that faces the sun, klx, linear Rec. 709; 0 for no sun. None: what the sky's model says,
  /// which is the atmosphere's own for a clear sky and no sun for the others.
  std::optional<Eigen::Vector3f> sun_irradiance_klx = std::nullopt;

  /// One line that names the field and its range when something is off.
  bool is_valid(std::string* why) const;
};

/// Unit vector from the world to the sun (y up).
Eigen::Vector3f direction_to_sun(const Daylight& daylight);

}  // namespace cps
