#pragma once

#include "renderer/lights/sky.h"
#include "renderer/lights/sun.h"

namespace cps {

struct SkyAndSun {
  Sky sky;
  Sun sun;
};

/// Sky and sun as `daylight` asks for. Throws std::runtime_error with one line for a picture that cannot be
/// used; `daylight` must be valid.
SkyAndSun make_sky_and_sun(const Daylight& daylight);

/// Sun and sky of a clear day, in proportion (see Atmosphere), and below the horizon a lit, hazy plain.
SkyAndSun make_clear_day(const Daylight& daylight);

/// The CIE's standard overcast sky (Moon & Spencer 1942; CIE S 011), three times brighter overhead than at
/// the horizon, as bright as overcast skies are on average by the sun's height (Krochmann 1963), of CIE
/// D65's white, the daylight of no particular sky; below the horizon a plain.
Sky make_overcast_sky(const Daylight& daylight);

/// An equirectangular picture (see Daylight). Throws std::runtime_error naming the file where it cannot be
/// read, is too large or holds values that are not finite; negative ones count as 0.
Sky make_image_sky(const Daylight& daylight);

}  // namespace cps
