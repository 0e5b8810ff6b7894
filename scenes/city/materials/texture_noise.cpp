#include "scenes/city/materials/texture_noise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps::city {
namespace {

std::uint64_t lattice(Stream stream, int x, int y, int period) {
  const auto wrap = [period](int i) { return static_cast<std::uint64_t>((i % period + period) % period); };
  return random_bits(stream, wrap(x) + wrap(y) * 65536);
}

double unit(std::uint64_t bits) {
  return static_cast<double>(bits & 0xffffffff) * 0x1p-32;
}

std::uint8_t to_byte(double x) {
  return static_cast<std::uint8_t>(std::clamp(x * 255.0 + 0.5, 0.0, 255.0));
}

}  // namespace

double gradient_noise(Stream stream, double u, double v, int period) {
  const double x = u * period, y = v * period;
  const int xi = static_cast<int>(std::floor(x)), yi = static_cast<int>(std::floor(y));
  const double fx = x - xi, fy = y - yi;
  const auto corner = [&](int dx, int dy) {
    // Eight directions suffice and need no trigonometry.
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

Cell cellular_noise(Stream stream, double u, double v, int period) {
  const double x = u * period, y = v * period;
  const int xi = static_cast<int>(std::floor(x)), yi = static_cast<int>(std::floor(y));
  Cell cell{9, 9, 0};
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint64_t h = lattice(stream, xi + dx, yi + dy, period);
      const double px = xi + dx + unit(h), py = yi + dy + unit(h >> 32);
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

TextureSet paint(int size, double tile_m, bool with_alpha,
                 const std::function<Texel(double, double)>& texel) {
  TextureSet set;
  set.base_color = {size, size, with_alpha ? 4 : 3, {}};
  set.normal = set.metallic_roughness = {size, size, 3, {}};
  for (Image* image : {&set.base_color, &set.normal, &set.metallic_roughness})
    image->pixels.resize(static_cast<std::size_t>(size) * size * image->channels);
  std::vector<float> height(static_cast<std::size_t>(size) * size);

  tbb::parallel_for(0, size, [&](int y) {
    for (int x = 0; x < size; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size + x;
      const Texel t = texel((x + 0.5) / size, (y + 0.5) / size);
      for (int c = 0; c < 3; ++c)
        set.base_color.pixels[i * set.base_color.channels + c] = to_byte(t.color[c]);
      if (with_alpha) set.base_color.pixels[i * 4 + 3] = to_byte(t.alpha);
      set.metallic_roughness.pixels[i * 3] = 255;
      set.metallic_roughness.pixels[i * 3 + 1] = to_byte(t.roughness);
      set.metallic_roughness.pixels[i * 3 + 2] = to_byte(t.metallic);
      height[i] = static_cast<float>(t.height_m);
    }
  });
  const double texel_m = tile_m / size;
  tbb::parallel_for(0, size, [&](int y) {
    const auto at = [&](int px, int py) {
      return static_cast<double>(
          height[static_cast<std::size_t>((py + size) % size) * size + (px + size) % size]);
    };
    for (int x = 0; x < size; ++x) {
      const double nx = -(at(x + 1, y) - at(x - 1, y)) / (2 * texel_m);
      const double ny =
          (at(x, y + 1) - at(x, y - 1)) / (2 * texel_m);  // green points up the image, rows run down
      const double scale = 0.5 / std::sqrt(nx * nx + ny * ny + 1);
      const std::size_t i = (static_cast<std::size_t>(y) * size + x) * 3;
      set.normal.pixels[i] = to_byte(0.5 + nx * scale);
      set.normal.pixels[i + 1] = to_byte(0.5 + ny * scale);
      set.normal.pixels[i + 2] = to_byte(0.5 + scale);
    }
  });
  return set;
}

}  // namespace cps::city
