#pragma once

#include <Eigen/Core>

#include "renderer/math/color.h"

namespace cps {

/// Values in 16 equal bins of wavelength from 380 to 740 nm.
using Spectrum = Eigen::Array<float, 16, 1>;

/// Middle of every bin, µm.
Spectrum wavelengths_um();

/// Sunlight before the atmosphere, W/m²/nm (ASTM G173-03, extraterrestrial column).
Spectrum solar_irradiance();

/// Absorption cross section of an ozone molecule at 233 K, m² (Serdyuchenko et al. 2014).
Spectrum ozone_cross_section();

/// W/(m² nm) → linear Rec. 709 in klx (and W/(m² nm sr) → kcd/m²), by the CIE 1931 observer as fitted by
/// Wyman, Sloan & Shirley (2013). White is D55, as for a camera balanced for daylight; colours outside the
/// gamut are clipped.
Color to_rec709(const Spectrum& spectrum);

/// CIE illuminant D65 (daylight at 6500 K) as that camera sees it: a little blue; luminance 1.
Color d65_white();

}  // namespace cps
