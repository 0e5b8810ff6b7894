#include "scenes/daylight.h"

#include <fmt/format.h>

#include <cmath>

#include "numbers/angles.h"

namespace cps {
namespace {

/// Empty if the value is within the range; otherwise a line that says so.
std::string range_fault(const char* name, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return "";
  return fmt::format("{} = {:g} must be within {:g} and {:g}", name, value, lowest, highest);
}

std::string light_fault(const char* name, const Eigen::Vector3f& color) {
  for (const float component : color)
    if (const std::string fault = range_fault(name, component, 0, 1e9); !fault.empty()) return fault;
  return "";
}

}  // namespace

std::string Daylight::fault() const {
  // A clear sky is computed down to the end of civil twilight (−6°); a sun of given irradiance may stand
  // anywhere.
  const double lowest_deg = sun_irradiance_klx ? -90 : sky == SkyModel::clear ? -6 : 0;
  if (sky == SkyModel::image && sky_image.empty()) return "sky_image: names no file";
  for (const std::string& fault :
       {range_fault("sun_elevation_deg", sun_elevation_deg, lowest_deg, 90),
        range_fault("sun_azimuth_deg", sun_azimuth_deg, -360, 360),
        range_fault("sun_angular_diameter_deg", sun_angular_diameter_deg, 0.01, 20),
        range_fault("turbidity", turbidity, 1.7, 10), light_fault("sky_radiance", sky_radiance),
        range_fault("sky_image_azimuth_deg", sky_image_azimuth_deg, -360, 360),
        range_fault("sky_image_scale", sky_image_scale, 0, 1e9)})
    if (!fault.empty()) return fault;
  return sun_irradiance_klx ? light_fault("sun_irradiance_klx", *sun_irradiance_klx) : "";
}

Eigen::Vector3f direction_to_sun(const Daylight& daylight) {
  const double elevation = radians(daylight.sun_elevation_deg), azimuth = radians(daylight.sun_azimuth_deg);
  return Eigen::Vector3d(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth))
      .cast<float>();
}

}  // namespace cps
