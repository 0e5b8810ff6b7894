#include "scenes/daylight.h"

#include <cmath>
#include <sstream>

#include "numbers/angles.h"

namespace cps {
namespace {

bool refuse(const std::string& line, std::string* why) {
  if (why) *why = line;
  return false;
}

bool within(const char* name, double value, double lowest, double highest, std::string* why) {
  if (value >= lowest && value <= highest) return true;
  std::ostringstream text;
  text << name << " = " << value << " must be within " << lowest << " and " << highest;
  return refuse(text.str(), why);
}

bool is_light(const char* name, const Eigen::Vector3f& color, std::string* why) {
  for (const float component : color)
    if (!within(name, component, 0, 1e9, why)) return false;
  return true;
}

}  // namespace

bool Daylight::is_valid(std::string* why) const {
  // A clear sky is computed down to the end of civil twilight (−6°); a sun of given irradiance may stand
  // anywhere.
  const double lowest_deg = sun_irradiance_klx ? -90 : sky == SkyModel::clear ? -6 : 0;
  if (sky == SkyModel::image && sky_image.empty()) return refuse("sky_image: names no file", why);
  return within("sun_elevation_deg", sun_elevation_deg, lowest_deg, 90, why) &&
         within("sun_azimuth_deg", sun_azimuth_deg, -360, 360, why) &&
         within("sun_angular_diameter_deg", sun_angular_diameter_deg, 0.01, 20, why) &&
         within("turbidity", turbidity, 1.7, 10, why) && is_light("sky_radiance", sky_radiance, why) &&
         within("sky_image_azimuth_deg", sky_image_azimuth_deg, -360, 360, why) &&
         within("sky_image_scale", sky_image_scale, 0, 1e9, why) &&
         (!sun_irradiance_klx || is_light("sun_irradiance_klx", *sun_irradiance_klx, why));
}

Eigen::Vector3f direction_to_sun(const Daylight& daylight) {
  const double elevation = radians(daylight.sun_elevation_deg), azimuth = radians(daylight.sun_azimuth_deg);
  return Eigen::Vector3d(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth))
      .cast<float>();
}

}  // namespace cps
