#include "apps/render/light_options.h"

#include <vector>

#include "apps/render/text_options.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// "R,G,B", or one number for all three.
Eigen::Vector3f parse_color(const std::string& option, const std::string& text) {
  const bool is_gray = text.find(',') == std::string::npos;
  const std::vector<double> numbers =
      parse_numbers(option, text, is_gray ? 1 : 3, "one number or R,G,B, linear Rec. 709");
  if (is_gray) return Eigen::Vector3f::Constant(static_cast<float>(numbers[0]));
  return Eigen::Map<const Eigen::Vector3d>(numbers.data()).cast<float>();
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.,eE+- ") == std::string::npos;
}

void set_sky(const std::string& text, Daylight& daylight) {
  if (text == "clear") {
    daylight.sky = SkyModel::clear;
  } else if (text == "overcast") {
    daylight.sky = SkyModel::overcast;
  } else if (is_number(text)) {
    daylight.sky = SkyModel::constant;
    daylight.sky_radiance = parse_color("sky", text);
  } else {
    daylight.sky = SkyModel::image;
    daylight.sky_image = text;
  }
}

}  // namespace

void describe_light(LightRequest& request, po::options_description_easy_init add) {
  Daylight& day = request.daylight;
  const auto number = [](double& target) { return po::value(&target)->default_value(target); };
  const auto text = [](std::optional<std::string>& target) {
    return po::value<std::string>()->notifier([&target](const std::string& value) { target = value; });
  };
  add("sky", text(request.sky)->value_name("SKY"),
      "clear, overcast, a radiance (kcd/m2, one number or R,G,B), or an equirectangular .hdr or .exr "
      "[clear]");
  add("sky-azimuth", number(day.sky_image_azimuth_deg),
      "direction of the middle column of a --sky picture, degrees clockwise from north (-z)");
  add("sky-scale", number(day.sky_image_scale), "radiance of a --sky picture's value 1, kcd/m2");
  add("turbidity", number(day.turbidity), "haze of a clear sky: 2 very clear, 3 clear, 6 hazy");
  add("sun-elevation", number(day.sun_elevation_deg), "height of the sun, degrees above the horizon");
  add("sun-azimuth", number(day.sun_azimuth_deg), "direction of the sun, degrees clockwise from north (-z)");
  add("sun-irradiance", text(request.sun_irradiance)->value_name("LIGHT"),
      "light of the sun on a surface that faces it, klx, one number or R,G,B; 0: no sun [as the clear sky's "
      "model says]");
  add("sun-diameter", number(day.sun_angular_diameter_deg), "angular diameter of the sun, degrees");
}

Daylight daylight_of(const LightRequest& request) {
  Daylight daylight = request.daylight;
  if (request.sky) set_sky(*request.sky, daylight);
  if (request.sun_irradiance)
    daylight.sun_irradiance_klx = parse_color("sun-irradiance", *request.sun_irradiance);
  if (const std::string fault = daylight.fault(); !fault.empty()) throw po::error(fault);
  return daylight;
}

}  // namespace cps
