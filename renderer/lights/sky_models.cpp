#include "renderer/lights/sky_models.h"

#include <tbb/parallel_for.h>

#include <numbers>

#include "distortion/pinhole.h"
#include "numbers/angles.h"
#include "renderer/lights/atmosphere.h"
#include "renderer/lights/spectrum.h"

namespace cps {
namespace {

constexpr int sky_columns = 256, sky_rows = 128;
constexpr float plain_albedo = 0.2f;    // of the land around the scene
constexpr float plain_depth_m = 60.0f;  // below the eye; sets how fast haze hides the plain

/// Fills the lower half with a plain under this irradiance, which fades into the sky at the horizon.
void add_plain(Sky& sky, const Atmosphere& atmosphere, const Color& on_level_ground) {
  const Color plain = on_level_ground * (plain_albedo * std::numbers::inv_pi_v<float>);
  for (int row = 0; row < sky.rows / 2; ++row) {
    for (int column = 0; column < sky.columns; ++column) {
      const float depression_sine = -cell_direction(sky, column, row).y();
      const float through = ground_air_transmittance(atmosphere, plain_depth_m / depression_sine);
      const Color horizon =
          sky.radiance_table[static_cast<std::size_t>(sky.rows / 2) * sky.columns + column].head<3>();
      set_cell(sky, column, row, plain * through + horizon * (1.0f - through));
    }
  }
}

/// The clear sky above the horizon.
Sky clear_dome(const Atmosphere& atmosphere, const Vec3& to_sun) {
  Sky sky = make_empty_sky(sky_columns, sky_rows, Rows::crowded_at_horizon);
  tbb::parallel_for(sky_rows / 2, sky_rows, [&](int row) {
    for (int column = 0; column < sky_columns; ++column) {
      set_cell(sky, column, row, sky_radiance(atmosphere, cell_direction(sky, column, row), to_sun));
    }
  });
  return sky;
}

Sun sun_of(const Daylight& daylight, const Color& of_the_model) {
  const Color irradiance =
      daylight.sun_irradiance_klx ? Color(daylight.sun_irradiance_klx->array()) : of_the_model;
  return make_sun(direction_to_sun(daylight), radians(daylight.sun_angular_diameter_deg), irradiance);
}

Color on_level_ground(const Sky& sky, const Vec3& to_sun, const Color& sunlight) {
  return horizontal_irradiance(sky) + sunlight * std::max(0.0f, to_sun.y());
}

}  // namespace

SkyAndSun make_sky_and_sun(const Daylight& daylight) {
  switch (daylight.sky) {
    case SkyModel::clear:
      return make_clear_day(daylight);
    case SkyModel::overcast:
      return {make_overcast_sky(daylight), sun_of(daylight, Color::Zero())};
    case SkyModel::constant:
      return {make_constant_sky(daylight.sky_radiance.array()), sun_of(daylight, Color::Zero())};
    case SkyModel::image:
      break;
  }
  return {make_image_sky(daylight), sun_of(daylight, Color::Zero())};
}

SkyAndSun make_clear_day(const Daylight& daylight) {
  const Vec3 to_sun = direction_to_sun(daylight);
  const Atmosphere atmosphere = make_atmosphere(daylight.turbidity);
  SkyAndSun day{clear_dome(atmosphere, to_sun), sun_of(daylight, sun_irradiance(atmosphere, to_sun))};
  const Color sunlight = day.sun.radiance / day.sun.pdf;
  add_plain(day.sky, atmosphere, on_level_ground(day.sky, to_sun, sunlight));
  day.sky.distribution = make_sky_distribution(day.sky);
  return day;
}

Sky make_overcast_sky(const Daylight& daylight) {
  const Vec3 to_sun = direction_to_sun(daylight);
  const Atmosphere atmosphere = make_atmosphere(daylight.turbidity);
  const float under_clouds_klx = 0.3f + 21.0f * std::max(0.0f, to_sun.y());
  // ∫ (1 + 2 sin γ)/3 · sin γ over the upper half is 7π/9.
  const Color zenith = d65_white() * (under_clouds_klx * 9.0f / (7.0f * std::numbers::pi_v<float>));

  Sky sky = make_empty_sky(sky_columns, sky_rows, Rows::crowded_at_horizon);
  for (int row = sky_rows / 2; row < sky_rows; ++row) {
    for (int column = 0; column < sky_columns; ++column) {
      const float sine = cell_direction(sky, column, row).y();
      set_cell(sky, column, row, zenith * ((1.0f + 2.0f * sine) / 3.0f));
    }
  }
  add_plain(sky, atmosphere, horizontal_irradiance(sky));
  sky.distribution = make_sky_distribution(sky);
  return sky;
}

}  // namespace cps
