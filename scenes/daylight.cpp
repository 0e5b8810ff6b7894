#include "scenes/daylight.h"

#include <cmath>
#include <numbers>
#include <sstream>

namespace cps {
namespace {

bool within(const char* name, double value, double lowest, double highest, std::string* why) {
  if (value >= lowest && value <= highest) return true;
  if (why) {
    std::ostringstream text;
    text << name << " = " << value << " must be within " << lowest << " and " << highest;
    *why = text.str();
  }
  return false;
}

}  // namespace

bool Daylight::is_valid(std::string* why) const {
  return within("sun_elevation_deg", sun_elevation_deg, 0, 90, why) &&
         within("sun_azimuth_deg", sun_azimuth_deg, -360, 360, why) &&
         within("sun_angular_diameter_deg", sun_angular_diameter_deg, 0.01, 20, why) &&
         within("turbidity", turbidity, 1.7, 10, why);
}

Eigen::Vector3f direction_to_sun(const Daylight& daylight) {
  constexpr double radians = std::numbers::pi / 180;
  const double elevation = daylight.sun_elevation_deg * radians, azimuth = daylight.sun_azimuth_deg * radians;
  return Eigen::Vector3d(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth))
      .cast<float>();
}

}  // namespace cps
