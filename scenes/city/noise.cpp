#include "scenes/city/noise.h"

#include <algorithm>
#include <cmath>

namespace cps::city {
namespace {

std::uint64_t lattice(Stream stream, int x, int y, int period) {
  const auto wrap = [period](int i) { return static_cast<std::uint64_t>((i % period + period) % period); };
  return random_bits(stream, wrap(x) + wrap(y) * 65536);
}

/// The low 32 bits as a number in [0, 1).
double low_bits_as_unit(std::uint64_t bits) {
  return static_cast<double>(bits & 0xffffffff) * 0x1p-32;
}

}  // namespace

double gradient_noise(Stream stream, double u, double v, int period) {
  const double x = u * period, y = v * period;
  const int xi = static_cast<int>(std::floor(x)), yi = static_cast<int>(std::floor(y));
  const double fx = x - xi, fy = y - yi;
  const auto corner = [&](int dx, int dy) {
    // Eight gradient directions are enough, and a table needs no trigonometry.
    static constexpr double gx[8] = {1, -1, 0, 0, .7071, -.7071, .7071, -.7071};
    static constexpr double gy[8] = {0, 0, 1, -1, .7071, .7071, -.7071, -.7071};
    const std::uint64_t h = lattice(stream, xi + dx, yi + dy, period) >> 61;
    return gx[h] * (fx - dx) + gy[h] * (fy - dy);
  };
  const auto ease = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double a = std::lerp(corner(0, 0), corner(1, 0), ease(fx));
  const double b = std::lerp(corner(0, 1), corner(1, 1), ease(fx));
  return 1.5 * std::lerp(a, b, ease(fy));
}

double fractal_noise(Stream stream, double u, double v, int period, int octaves) {
  double sum = 0, amplitude = 0.55;
  for (int o = 0; o < octaves; ++o, amplitude *= 0.5, period *= 2)
    sum += amplitude * gradient_noise(substream(stream, o), u, v, period);
  return sum;
}

CellularNoise cellular_noise(Stream stream, double u, double v, int period) {
  const double x = u * period, y = v * period;
  const int xi = static_cast<int>(std::floor(x)), yi = static_cast<int>(std::floor(y));
  CellularNoise cell{9, 9, 0};
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint64_t h = lattice(stream, xi + dx, yi + dy, period);
      const double px = xi + dx + low_bits_as_unit(h), py = yi + dy + low_bits_as_unit(h >> 32);
      const double d = std::hypot(px - x, py - y);
      if (d < cell.nearest) {
        cell.second = cell.nearest;
        cell.nearest = d;
        cell.id = h;
      } else {
        cell.second = std::min(cell.second, d);
      }
    }
  return cell;
}

}  // namespace cps::city
