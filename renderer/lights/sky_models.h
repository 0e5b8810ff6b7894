#pragma once

#include "renderer/lights/sky.h"
#include "renderer/lights/sun.h"

namespace cps {

struct SkyAndSun {
  Sky sky;
  Sun sun;
};

/// Sky and sun by `daylight`, which must be valid. Throws std::runtime_error in one line for a picture that
/// cannot be used.
SkyAndSun make_sky_and_sun(const Daylight& daylight);

/// Sun and sky of a clear day (see Atmosphere), and below the horizon a lit, hazy plain.
SkyAndSun make_clear_day(const Daylight& daylight);

/// The CIE's standard overcast sky (Moon & Spencer 1942; CIE S 011), three times brighter overhead than at
/// the horizon; of the mean brightness of overcast skies at the sun's elevation (Krochmann 1963) and the
/// colour of CIE D65, standard daylight; below the horizon a plain.
Sky make_overcast_sky(const Daylight& daylight);

/// The sky of an equirectangular picture (see Daylight). Throws std::runtime_error that names the file if it
/// cannot be read, is too large or holds values that are not finite; negative values count as 0.
Sky make_image_sky(const Daylight& daylight);

}  // namespace cps
