#include "distortion/warp/gather.h"

#include <cmath>
#include <cstring>

namespace cps {
namespace {

constexpr int lanes = 8;
using Float8 = float __attribute__((vector_size(32)));

Float8 load(const float* values) {
  Float8 vector;
  std::memcpy(&vector, values, sizeof vector);
  return vector;
}

float sum(Float8 v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// Sums over the bounds, eight columns at a time. On one row the kernel's argument is a quadratic in x.
template <int channels>
void gather_channels(const PlanarPatch& patch, const FootprintTile& tile, int index,
                     const PixelBounds& bounds, float* pixel) {
  const float xx = tile.conic_xx[index], xy = 2 * tile.conic_xy[index], yy = tile.conic_yy[index];
  const float first_x = static_cast<float>(bounds.x0 - tile.x[index]),
              first_y = static_cast<float>(bounds.y0 - tile.y[index]);
  const std::size_t plane = patch.stride * patch.rect.height;
  const float* corner = patch.row(0, bounds.y0) + (bounds.x0 - patch.rect.x0);

  Float8 weights{}, sums[channels]{};
  for (int column = 0; column <= bounds.x1 - bounds.x0; column += lanes) {
    const Float8 x = Float8{0, 1, 2, 3, 4, 5, 6, 7} + (first_x + column);
    const Float8 at_centre_row = 1 - xx * x * x, per_y = xy * x;
    const float* row = corner + column;
    float y = first_y;
    for (int line = bounds.y0; line <= bounds.y1; ++line, y += 1, row += patch.stride) {
      const Float8 t = at_centre_row - per_y * y - yy * y * y;
      const Float8 inside = t > 0 ? t : Float8{};
      const Float8 weight = inside * inside * inside;
      weights += weight;
      for (int channel = 0; channel < channels; ++channel)
        sums[channel] += weight * load(row + channel * plane);
    }
  }
  const float scale = 1 / sum(weights);
  for (int channel = 0; channel < channels; ++channel) pixel[channel] = sum(sums[channel]) * scale;
}

}  // namespace

void read_patch(const OIIO::ImageBuf& image, const TileRect& rect, PlanarPatch& patch) {
  const OIIO::ImageSpec& spec = image.spec();
  const auto [x0, y0, width, height] = rect;
  patch.rect = rect;
  patch.channels = spec.nchannels;
  patch.stride = width + lanes;
  patch.values.assign(patch.stride * height * patch.channels + lanes, 0.0f);

  std::vector<float> interleaved(std::size_t(width) * patch.channels);
  for (int y = y0; y < y0 + height; ++y) {
    const void* pixels = image.pixeladdr(spec.x + x0, spec.y + y);
    OIIO::convert_pixel_values(spec.format, pixels, OIIO::TypeFloat, interleaved.data(),
                               int(interleaved.size()));
    for (int channel = 0; channel < patch.channels; ++channel) {
      float* row = const_cast<float*>(patch.row(channel, y));
      for (int x = 0; x < width; ++x) row[x] = interleaved[std::size_t(x) * patch.channels + channel];
    }
  }
}

PixelBounds pixel_bounds(const FootprintTile& tile, int index) {
  const double x = tile.x[index], y = tile.y[index], width = tile.half_width[index],
               height = tile.half_height[index];
  return {int(std::ceil(x - width)), int(std::ceil(y - height)), int(std::floor(x + width)),
          int(std::floor(y + height))};
}

bool is_footprint_inside(const FootprintTile& tile, int index, int width, int height) {
  const double x = tile.x[index], y = tile.y[index];
  // The negation makes NaN count as outside. Positions too large for an int must not reach pixel_bounds().
  if (!(x >= 0 && y >= 0 && x < width && y < height)) return false;
  const PixelBounds bounds = pixel_bounds(tile, index);
  return bounds.x0 >= 0 && bounds.y0 >= 0 && bounds.x1 < width && bounds.y1 < height;
}

void gather(const PlanarPatch& patch, const FootprintTile& tile, int index, const PixelBounds& bounds,
            float* pixel) {
  switch (patch.channels) {
    case 1:
      return gather_channels<1>(patch, tile, index, bounds, pixel);
    case 2:
      return gather_channels<2>(patch, tile, index, bounds, pixel);
    case 3:
      return gather_channels<3>(patch, tile, index, bounds, pixel);
    default:
      return gather_channels<4>(patch, tile, index, bounds, pixel);
  }
}

}  // namespace cps
