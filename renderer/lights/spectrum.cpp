#include "renderer/lights/spectrum.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace cps {
namespace {

constexpr float first_nm = 380, bin_nm = 22.5f;
constexpr int bins = 16;

/// Tables every 10 nm from 380 to 740.
using Table = std::array<float, 37>;

constexpr Table solar = {1.01249f, 1.14716f, 1.72765f, 1.73054f, 1.6887f,  1.61253f, 1.91198f, 2.03474f,
                         2.02042f, 2.02212f, 1.93377f, 1.95809f, 1.91686f, 1.8298f,  1.8685f,  1.8931f,
                         1.85149f, 1.8504f,  1.8341f,  1.8345f,  1.8147f,  1.78158f, 1.7533f,  1.6965f,
                         1.68194f, 1.64654f, 1.6048f,  1.52143f, 1.55622f, 1.5113f,  1.474f,   1.4482f,
                         1.41018f, 1.36775f, 1.34188f, 1.31429f, 1.28303f};

/// 1e-26 m².
constexpr Table ozone = {0.02818f, 0.06636f, 0.1527f, 0.2763f, 0.552f, 0.8451f, 1.582f, 2.316f,
                         3.669f,   4.924f,   7.752f,  9.016f,  14.8f,  16.02f,  21.39f, 27.55f,
                         30.91f,   35.0f,    42.66f,  46.72f,  43.98f, 47.01f,  50.19f, 43.05f,
                         37.4f,    32.15f,   26.62f,  22.38f,  18.52f, 14.73f,  12.09f, 9.423f,
                         7.455f,   6.566f,   5.105f,  4.15f,   4.228f};

/// Mean of a table, linear between its entries, over every bin.
Spectrum binned(const Table& table) {
  constexpr int steps = 45;
  Spectrum result;
  for (int bin = 0; bin < bins; ++bin) {
    float sum = 0;
    for (int step = 0; step < steps; ++step) {
      const float position =
          (static_cast<float>(bin) + (static_cast<float>(step) + 0.5f) / steps) * bin_nm / 10.0f;
      const int i = static_cast<int>(position);
      sum += table[i] + (position - static_cast<float>(i)) * (table[i + 1] - table[i]);
    }
    result[bin] = sum / steps;
  }
  return result;
}

/// A Gaussian with a width on either side.
double lobe(double nm, double mean, double below, double above) {
  const double t = (nm - mean) / (nm < mean ? below : above);
  return std::exp(-0.5 * t * t);
}

Eigen::Vector3d observer(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

const Eigen::Vector3d d55_xyz(0.95682, 1, 0.92149), d65_xyz(0.95047, 1, 1.08883);

/// For a camera balanced for D55.
Eigen::Matrix3d rec709_from_xyz() {
  Eigen::Matrix3d rec709_of_d65, cones_from_xyz;
  rec709_of_d65 << 3.2406255, -1.5372080, -0.4986286, -0.9689307, 1.8757561, 0.0415175, 0.0557101, -0.2040211,
      1.0569959;
  cones_from_xyz << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685,
      1.0296;  // Bradford (Lam 1985)
  const Eigen::Vector3d gains = (cones_from_xyz * d65_xyz).cwiseQuotient(cones_from_xyz * d55_xyz);
  return rec709_of_d65 * cones_from_xyz.inverse() * gains.asDiagonal() * cones_from_xyz;
}

/// Rows: what a unit of spectral power in every bin adds to red, green and blue.
Eigen::Matrix<float, 3, bins> rec709_from_bins() {
  const Eigen::Matrix3d balanced = rec709_from_xyz();
  constexpr double kilolumen_per_watt = 0.683;
  constexpr int steps = 45;
  Eigen::Matrix<float, 3, bins> matrix;
  for (int bin = 0; bin < bins; ++bin) {
    Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
    for (int step = 0; step < steps; ++step)
      xyz += observer(first_nm + (bin + (step + 0.5) / steps) * bin_nm);
    matrix.col(bin) = (kilolumen_per_watt * bin_nm / steps * (balanced * xyz)).cast<float>();
  }
  return matrix;
}

}  // namespace

Spectrum wavelengths_um() {
  return Spectrum::LinSpaced((first_nm + 0.5f * bin_nm) * 1e-3f, (first_nm + (bins - 0.5f) * bin_nm) * 1e-3f);
}

Spectrum solar_irradiance() {
  return binned(solar);
}

Spectrum ozone_cross_section() {
  return binned(ozone) * 1e-26f;
}

Color to_rec709(const Spectrum& spectrum) {
  static const Eigen::Matrix<float, 3, bins> matrix = rec709_from_bins();
  return (matrix * spectrum.matrix()).array().max(0.0f);
}

Color d65_white() {
  const Color white = (rec709_from_xyz() * d65_xyz).cast<float>().array();
  return white / luminance(white);
}

}  // namespace cps
