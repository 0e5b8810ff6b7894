#pragma once

#include <Eigen/Core>
#include <string>

namespace cps {

/// Sun and sky of one condition.
struct Daylight {
  double sun_elevation_deg = 40;  ///< above the horizon
  double sun_azimuth_deg = 135;   ///< clockwise from north seen from above; north is world −z, east +x
  double sun_angular_diameter_deg = 0.53;
  double turbidity = 3;  ///< 2 is very clear, 3 clear, 6 hazy (Preetham, Shirley & Smits 1999)
  /// One line that names the field and its range when something is off.
  bool is_valid(std::string* why) const;
};

/// Unit vector from the world to the sun (y up).
Eigen::Vector3f direction_to_sun(const Daylight& daylight);

}  // namespace cps
