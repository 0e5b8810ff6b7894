#include "renderer/lights/atmosphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps {
namespace {

using std::numbers::pi;
constexpr double ground_m = 6360e3, top_m = 6460e3;                 // radii
constexpr double rayleigh_height_m = 8000, haze_height_m = 1200;    // densities fall to 1/e
constexpr double ozone_middle_m = 25e3, ozone_half_width_m = 15e3;  // a tent
constexpr double eye_m = 2;                                         // above the ground
constexpr float haze_albedo = 0.94f, haze_asymmetry = 0.8f, ground_albedo = 0.2f;

constexpr int heights = 32, zenith_cosines = 128;    // transmittance table
constexpr int ms_heights = 24, ms_sun_cosines = 24;  // multiple scattering table

/// A point by its distance from Earth's centre, and a direction by its cosine to the zenith there.
struct Sight {
  double radius, cosine;
};

/// Negative: the ray's line passes by the sphere.
double discriminant(const Sight& s, double sphere_radius) {
  return sphere_radius * sphere_radius - s.radius * s.radius * (1.0 - s.cosine * s.cosine);
}

bool meets_ground(const Sight& s) {
  return s.cosine < 0.0 && discriminant(s, ground_m) >= 0.0;
}

/// To where the ray leaves the air: the ground or the top.
double distance_through_air(const Sight& s) {
  if (meets_ground(s)) return std::max(0.0, -s.radius * s.cosine - std::sqrt(discriminant(s, ground_m)));
  return std::max(0.0, -s.radius * s.cosine + std::sqrt(std::max(0.0, discriminant(s, top_m))));
}

/// The sight's point moved along it, there looking in a direction whose cosine to the zenith was
/// `cosine_at_start` and to the sight is `cosine_to_sight`.
Sight seen_along(const Sight& s, double distance, double cosine_at_start, double cosine_to_sight) {
  const double radius =
      std::sqrt(distance * distance + 2.0 * s.radius * s.cosine * distance + s.radius * s.radius);
  return {std::clamp(radius, ground_m, top_m),
          std::clamp((s.radius * cosine_at_start + distance * cosine_to_sight) / radius, -1.0, 1.0)};
}

struct Medium {
  Spectrum rayleigh, haze, extinction;  // scattering by either, and all that is lost, 1/m
};

Medium medium_at(const Atmosphere& a, double height) {
  const auto air = static_cast<float>(std::exp(-height / rayleigh_height_m));
  const auto haze = static_cast<float>(std::exp(-height / haze_height_m));
  const auto ozone =
      static_cast<float>(std::max(0.0, 1.0 - std::abs(height - ozone_middle_m) / ozone_half_width_m));
  Medium medium;
  medium.rayleigh = a.rayleigh_scattering * air;
  medium.haze = a.haze_scattering * haze;
  medium.extinction = medium.rayleigh + a.haze_extinction * haze + a.ozone_absorption * ozone;
  return medium;
}

/// Walks through the air in steps that grow quadratically (fine near the eye, where the haze is), calling
/// `visit(distance, ∫ transmittance over the step, medium)`; returns the transmittance of the whole way.
template <class Visit>
Spectrum march(const Atmosphere& a, const Sight& from, int steps, Visit visit) {
  const double distance = distance_through_air(from);
  Spectrum transmittance = Spectrum::Ones();
  double begin = 0;
  for (int step = 0; step < steps; ++step) {
    const double fraction = static_cast<double>(step + 1) / steps;
    const double end = distance * fraction * fraction, middle = 0.5 * (begin + end);
    const Medium medium = medium_at(a, seen_along(from, middle, from.cosine, 1.0).radius - ground_m);
    const Spectrum through = (-medium.extinction * static_cast<float>(end - begin)).exp();
    visit(middle, transmittance * (1.0f - through) / medium.extinction, medium);
    transmittance *= through;
    begin = end;
  }
  return transmittance;
}

Spectrum transmittance_to_top(const Atmosphere& a, const Sight& from, int steps) {
  return march(a, from, steps, [](double, const Spectrum&, const Medium&) {});
}

/// Two-dimensional table lookup, (x, y) in [0, 1]².
Spectrum lookup(const std::vector<Spectrum>& table, int width, int height, double x, double y) {
  const auto px = static_cast<float>(std::clamp(x, 0.0, 1.0) * (width - 1));
  const auto py = static_cast<float>(std::clamp(y, 0.0, 1.0) * (height - 1));
  const int ix = std::min(static_cast<int>(px), width - 2), iy = std::min(static_cast<int>(py), height - 2);
  const float fx = px - static_cast<float>(ix), fy = py - static_cast<float>(iy);
  const Spectrum* row = &table[static_cast<std::size_t>(iy) * width + ix];
  return (row[0] * (1.0f - fx) + row[1] * fx) * (1.0f - fy) +
         (row[width] * (1.0f - fx) + row[width + 1] * fx) * fy;
}

// The transmittance table's coordinates are distances, which vary smoothly where cosines crowd at the horizon
// (Bruneton & Neyret 2008, "Precomputed atmospheric scattering").
const double horizon_of_top_m = std::sqrt(top_m * top_m - ground_m * ground_m);

Spectrum sun_transmittance(const Atmosphere& a, const Sight& towards_sun) {
  if (meets_ground(towards_sun)) return Spectrum::Zero();
  const double rho = std::sqrt(std::max(0.0, towards_sun.radius * towards_sun.radius - ground_m * ground_m));
  const double nearest = top_m - towards_sun.radius, farthest = rho + horizon_of_top_m;
  const double x = (distance_through_air(towards_sun) - nearest) / (farthest - nearest);
  return lookup(a.transmittance, zenith_cosines, heights, x, rho / horizon_of_top_m);
}

std::vector<Spectrum> make_transmittance_table(const Atmosphere& a) {
  std::vector<Spectrum> table(static_cast<std::size_t>(heights) * zenith_cosines);
  tbb::parallel_for(0, heights, [&](int y) {
    const double rho = horizon_of_top_m * y / (heights - 1);
    const double radius = std::sqrt(rho * rho + ground_m * ground_m);
    for (int x = 0; x < zenith_cosines; ++x) {
      const double nearest = top_m - radius, farthest = rho + horizon_of_top_m;
      const double d = nearest + (farthest - nearest) * x / (zenith_cosines - 1);
      const double cosine =
          d == 0 ? 1 : (horizon_of_top_m * horizon_of_top_m - rho * rho - d * d) / (2 * radius * d);
      // At the horizon the rounded cosine must not dip the ray into the ground.
      const double horizon = -std::sqrt(std::max(0.0, 1 - ground_m * ground_m / (radius * radius)));
      table[static_cast<std::size_t>(y) * zenith_cosines + x] =
          transmittance_to_top(a, {radius, std::clamp(cosine, std::min(0.0, horizon + 1e-9), 1.0)}, 64);
    }
  });
  return table;
}

// The multiple scattering table: height by its square root, the sun's cosine evenly.
double row_of_height(double height) {
  return std::sqrt(std::max(0.0, height) / (top_m - ground_m));
}
double height_of_row(double row) {
  return row * row * (top_m - ground_m);
}

Spectrum higher_orders(const Atmosphere& a, const Sight& towards_sun) {
  return lookup(a.multiple_scattering, ms_sun_cosines, ms_heights, 0.5 + 0.5 * towards_sun.cosine,
                row_of_height(towards_sun.radius - ground_m));
}

/// Hillaire's equations 5 to 10: light scattered twice, summed over all directions with an even phase
/// function, and the share of it that every further order keeps, as a geometric series.
Spectrum scattered_more_than_once(const Atmosphere& a, const Sight& towards_sun) {
  constexpr int directions = 64, steps = 24;
  constexpr float even_phase = static_cast<float>(1 / (4 * pi)),
                  ground_bsdf = static_cast<float>(ground_albedo / pi);
  const double sun_sine = std::sqrt(1.0 - towards_sun.cosine * towards_sun.cosine);
  Spectrum second_order = Spectrum::Zero(), kept = Spectrum::Zero();
  for (int i = 0; i < directions; ++i) {
    // A spherical Fibonacci lattice.
    const double cosine = 1.0 - (2.0 * i + 1.0) / directions;
    const double azimuth = i * pi * (3.0 - std::sqrt(5.0));
    const double cos_to_sun =
        cosine * towards_sun.cosine + std::sqrt(1.0 - cosine * cosine) * sun_sine * std::cos(azimuth);
    const Sight from{towards_sun.radius, cosine};
    const auto sun_from = [&](double distance) {
      return seen_along(from, distance, towards_sun.cosine, cos_to_sun);
    };
    const Spectrum through =
        march(a, from, steps, [&](double distance, const Spectrum& in_step, const Medium& medium) {
          const Spectrum scattered = (medium.rayleigh + medium.haze) * in_step;
          second_order += even_phase * scattered * sun_transmittance(a, sun_from(distance));
          kept += scattered;
        });
    if (meets_ground(from)) {
      const Sight sun = sun_from(distance_through_air(from));
      second_order +=
          through * sun_transmittance(a, sun) * (ground_bsdf * static_cast<float>(std::max(0.0, sun.cosine)));
    }
  }
  return second_order / directions / (1.0f - kept / directions);
}

std::vector<Spectrum> make_multiple_scattering_table(const Atmosphere& a) {
  std::vector<Spectrum> table(static_cast<std::size_t>(ms_heights) * ms_sun_cosines);
  tbb::parallel_for(0, ms_heights, [&](int y) {
    const double height =
        std::clamp(height_of_row(static_cast<double>(y) / (ms_heights - 1)), 1.0, top_m - ground_m - 1.0);
    for (int x = 0; x < ms_sun_cosines; ++x) {
      const double cosine = 2.0 * x / (ms_sun_cosines - 1) - 1.0;
      table[static_cast<std::size_t>(y) * ms_sun_cosines + x] =
          scattered_more_than_once(a, {ground_m + height, cosine});
    }
  });
  return table;
}

float rayleigh_phase(double cosine) {
  return static_cast<float>(3.0 / (16.0 * pi) * (1.0 + cosine * cosine));
}

/// Cornette & Shanks (1992).
float haze_phase(double cosine) {
  constexpr double g = haze_asymmetry, g2 = g * g;
  const double d = 1.0 + g2 - 2.0 * g * cosine;
  return static_cast<float>(3.0 / (8.0 * pi) * (1.0 - g2) / (2.0 + g2) * (1.0 + cosine * cosine) /
                            (d * std::sqrt(d)));
}

}  // namespace

Atmosphere make_atmosphere(double turbidity) {
  Atmosphere a;
  const Spectrum um = wavelengths_um();
  a.sunlight = solar_irradiance();
  // Air at sea level: 1.24062e-6/m at 1 µm (as in Bruneton's 2017 implementation of Bruneton & Neyret 2008),
  // by λ⁻⁴.
  a.rayleigh_scattering = 1.24062e-6f / um.square().square();
  // Vertical optical depth of the haze β λ^−1.3 (Preetham et al. 1999, appendix 1).
  const float beta = std::max(0.0f, 0.04608f * static_cast<float>(turbidity) - 0.04586f);
  a.haze_extinction = beta * um.pow(-1.3f) / static_cast<float>(haze_height_m);
  a.haze_scattering = haze_albedo * a.haze_extinction;
  constexpr float molecules_per_m2 = 300 * 2.687e20f;  // 300 Dobson units
  a.ozone_absorption = ozone_cross_section() * (molecules_per_m2 / static_cast<float>(ozone_half_width_m));
  a.transmittance = make_transmittance_table(a);
  a.multiple_scattering = make_multiple_scattering_table(a);
  return a;
}

Color sky_radiance(const Atmosphere& a, const Vec3& direction, const Vec3& to_sun) {
  const Sight from{ground_m + eye_m, std::max(0.0f, direction.y())};
  const double cos_to_sun = std::clamp(direction.dot(to_sun), -1.0f, 1.0f);
  const float rayleigh = rayleigh_phase(cos_to_sun), haze = haze_phase(cos_to_sun);
  Spectrum radiance = Spectrum::Zero();
  march(a, from, 48, [&](double distance, const Spectrum& in_step, const Medium& medium) {
    const Sight sun = seen_along(from, distance, to_sun.y(), cos_to_sun);
    radiance += in_step * (sun_transmittance(a, sun) * (medium.rayleigh * rayleigh + medium.haze * haze) +
                           higher_orders(a, sun) * (medium.rayleigh + medium.haze));
  });
  return to_rec709(radiance * a.sunlight);
}

Color sun_irradiance(const Atmosphere& a, const Vec3& to_sun) {
  const Sight sight{ground_m + eye_m, to_sun.y()};
  if (to_sun.y() <= 0.0f) return Color::Zero();
  return to_rec709(transmittance_to_top(a, sight, 256) * a.sunlight);
}

float ground_air_transmittance(const Atmosphere& a, float distance_m) {
  const Spectrum through = (-medium_at(a, 0).extinction * distance_m).exp();
  return luminance(to_rec709(a.sunlight * through)) / luminance(to_rec709(a.sunlight));
}

}  // namespace cps
