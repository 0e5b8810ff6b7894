#include "renderer/sky.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "distortion/pinhole.h"
#include "renderer/atmosphere.h"
#include "renderer/frame.h"

namespace cps {
namespace {

constexpr int sky_columns = 256, sky_rows = 128;
constexpr int distribution_columns = 64, distribution_rows = 64;
constexpr float plain_albedo = 0.2f;  // of the country around the scene
constexpr float plain_depth_m =
    60.0f;  // how far the eye seems above it, which sets how soon haze swallows it

/// Direction of the middle of a cell.
Vec3 cell_direction(const Sky& sky, int column, int row) {
  return direction_at((static_cast<float>(column) + 0.5f) / static_cast<float>(sky.columns),
                      elevation_sine_of_row((static_cast<float>(row) + 0.5f) / static_cast<float>(sky.rows)));
}

Sky empty_sky(int columns, int rows) {
  return {columns,
          rows,
          std::vector<Eigen::Array4f>(static_cast<std::size_t>(columns) * rows, Eigen::Array4f::Zero()),
          {}};
}

void set_cell(Sky& sky, int column, int row, const Color& radiance) {
  sky.radiance_table[static_cast<std::size_t>(row) * sky.columns + column] << radiance, 0.0f;
}

/// Importance by the mean luminance of every cell.
DirectionDistribution distribution_of(const Sky& sky) {
  std::vector<float> weights;
  constexpr int points = 4;
  for (int row = 0; row < distribution_rows; ++row) {
    for (int column = 0; column < distribution_columns; ++column) {
      float sum = 0;
      for (int i = 0; i < points * points; ++i) {
        const float x = (static_cast<float>(column) + (static_cast<float>(i % points) + 0.5f) / points) /
                        distribution_columns;
        const float y =
            (static_cast<float>(row) + (static_cast<float>(i / points) + 0.5f) / points) / distribution_rows;
        sum += luminance(sky.radiance(direction_at(x, elevation_sine_of_row(y))));
      }
      weights.push_back(sum);
    }
  }
  return make_direction_distribution(distribution_columns, distribution_rows, weights);
}

/// What the upper half of the sky sends to level ground, klx.
Color horizontal_irradiance(const Sky& sky) {
  Color sum = Color::Zero();
  for (int row = sky.rows / 2; row < sky.rows; ++row) {
    const float low = elevation_sine_of_row(static_cast<float>(row) / static_cast<float>(sky.rows));
    const float high = elevation_sine_of_row(static_cast<float>(row + 1) / static_cast<float>(sky.rows));
    const float cosine_sr =
        std::numbers::pi_v<float> * (high * high - low * low) / static_cast<float>(sky.columns);
    for (int column = 0; column < sky.columns; ++column) {
      sum += cosine_sr * sky.radiance_table[static_cast<std::size_t>(row) * sky.columns + column].head<3>();
    }
  }
  return sum;
}

}  // namespace

Color Sky::radiance(const Vec3& direction) const {
  const Eigen::Vector2f at = table_coordinates(direction);
  const float x = at.x() * static_cast<float>(columns) - 0.5f;
  const float y = std::clamp(at.y() * static_cast<float>(rows) - 0.5f, 0.0f, static_cast<float>(rows - 1));
  const float floor_x = std::floor(x);
  const int column = static_cast<int>(floor_x), row = std::min(static_cast<int>(y), rows - 2);
  const int left = column < 0 ? columns - 1 : column, right = column + 1 < columns ? column + 1 : 0;
  const float fx = x - floor_x, fy = y - static_cast<float>(row);
  const Eigen::Array4f* low = &radiance_table[static_cast<std::size_t>(row) * columns];
  const Eigen::Array4f* high = low + columns;
  const Eigen::Array4f value = (low[left] * (1.0f - fx) + low[right] * fx) * (1.0f - fy) +
                               (high[left] * (1.0f - fx) + high[right] * fx) * fy;
  return value.head<3>();
}

Vec3 Sun::sample(const Eigen::Vector2f& u) const {
  const float chord2_here = u.y() * chord2;
  const SinCos azimuth = sincos_of_turns(u.x());
  const float sine = std::sqrt(chord2_here * (1.0f - 0.25f * chord2_here));
  return frame_around(direction).to_world(
      {sine * azimuth.cos, sine * azimuth.sin, 1.0f - 0.5f * chord2_here});
}

Sun make_sun(const Vec3& direction, double angular_diameter_rad, const Color& irradiance) {
  Sun sun;
  sun.direction = direction;
  const double chord = 2.0 * std::sin(0.25 * angular_diameter_rad);
  sun.chord2 = static_cast<float>(chord * chord);
  sun.pdf = static_cast<float>(1.0 / (std::numbers::pi * chord * chord));
  sun.radiance = irradiance * sun.pdf;
  return sun;
}

SkyAndSun make_clear_day(const Daylight& daylight) {
  const Vec3 to_sun = direction_to_sun(daylight);
  const Atmosphere atmosphere = make_atmosphere(daylight.turbidity);
  const Color sunlight = sun_irradiance(atmosphere, to_sun);

  Sky sky = empty_sky(sky_columns, sky_rows);
  tbb::parallel_for(sky_rows / 2, sky_rows, [&](int row) {
    for (int column = 0; column < sky_columns; ++column) {
      set_cell(sky, column, row, sky_radiance(atmosphere, cell_direction(sky, column, row), to_sun));
    }
  });

  const Color on_level_ground = sunlight * std::max(0.0f, to_sun.y()) + horizontal_irradiance(sky);
  const Color plain = on_level_ground * (plain_albedo * std::numbers::inv_pi_v<float>);
  for (int row = 0; row < sky_rows / 2; ++row) {
    for (int column = 0; column < sky_columns; ++column) {
      const float depression_sine = -cell_direction(sky, column, row).y();
      const float through = ground_air_transmittance(atmosphere, plain_depth_m / depression_sine);
      const Color horizon =
          sky.radiance_table[static_cast<std::size_t>(sky_rows / 2) * sky_columns + column].head<3>();
      set_cell(sky, column, row, plain * through + horizon * (1.0f - through));
    }
  }
  sky.distribution = distribution_of(sky);
  return {std::move(sky), make_sun(to_sun, radians(daylight.sun_angular_diameter_deg), sunlight)};
}

Sky make_constant_sky(const Color& radiance) {
  Sky sky = empty_sky(2, 2);
  for (int i = 0; i < 4; ++i) set_cell(sky, i % 2, i / 2, radiance);
  sky.distribution = distribution_of(sky);
  return sky;
}

}  // namespace cps
