#pragma once

#include <vector>

#include "renderer/lights/spectrum.h"

namespace cps {

/// A physical model of a clear sky: Rayleigh scattering, ozone, and haze around a spherical Earth, at 16
/// wavelengths; single scattering by ray marching, higher orders as Hillaire (2020, "A scalable and
/// production ready sky and atmosphere rendering technique"). Sun and sky come from one solar spectrum, so
/// that the model decides their ratio.
struct Atmosphere {
  Spectrum rayleigh_scattering, haze_scattering, haze_extinction,
      ozone_absorption;                 ///< 1/m where each is densest
  Spectrum sunlight;                    ///< before the atmosphere, W/(m² nm)
  std::vector<Spectrum> transmittance;  ///< to the top, by height and cosine to the zenith
  std::vector<Spectrum>
      multiple_scattering;  ///< light of higher orders over sunlight, by height and the sun's cosine
};

/// `turbidity` as Preetham, Shirley & Smits (1999) define it: optical thickness of haze and air over that of
/// air alone, with their haze (Ångström's exponent 1.3).
Atmosphere make_atmosphere(double turbidity);

/// Sky radiance (kcd/m², linear Rec. 709) seen near the ground in a direction at or above the horizon,
/// without the sun's disc. Unit vectors, y up; the sun may be below the horizon.
Color sky_radiance(const Atmosphere& atmosphere, const Vec3& direction, const Vec3& to_sun);

/// Sunlight near the ground on a surface that faces the sun (klx, linear Rec. 709); 0 once the sun has set.
Color sun_irradiance(const Atmosphere& atmosphere, const Vec3& to_sun);

/// Transmittance of `distance_m` of air near the ground, by luminance.
float ground_air_transmittance(const Atmosphere& atmosphere, float distance_m);

}  // namespace cps
