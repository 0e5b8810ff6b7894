#include "distortion/warp/planar_patch.h"

#include <algorithm>

#include "distortion/warp/channel_count.h"

namespace cps {
namespace {

/// Sorts a row of pixels into planes that lie `plane` floats apart.
template <int channels>
void split_row(const float* __restrict pixels, int width, std::size_t plane, float* __restrict row) {
  for (int x = 0; x < width; ++x)
    for (int channel = 0; channel < channels; ++channel)
      row[channel * plane + x] = pixels[x * channels + channel];
}

/// Asks for a row of an image, so that it is on its way from memory when it is read.
void prefetch_row(const void* row, std::size_t bytes) {
  constexpr std::size_t cache_line = 64;
  for (std::size_t i = 0; i < bytes; i += cache_line) __builtin_prefetch(static_cast<const char*>(row) + i);
}

}  // namespace

void read_patch(const OIIO::ImageBuf& image, const TileRect& rect, PlanarPatch& patch) {
  const OIIO::ImageSpec& spec = image.spec();
  patch.rect = rect;
  patch.channels = spec.nchannels;
  patch.stride = rect.width + PlanarPatch::padding;
  const std::size_t plane = patch.stride * rect.height;
  patch.values.resize(plane * patch.channels);

  const bool is_float = spec.format == OIIO::TypeFloat;
  std::vector<float> converted(is_float ? 0 : std::size_t(rect.width) * patch.channels);
  const auto stored_row = [&](int line) {
    return image.pixeladdr(spec.x + rect.x0, spec.y + rect.y0 + line);
  };
  constexpr int ahead = 4;
  for (int line = 0; line < rect.height; ++line) {
    if (line + ahead < rect.height)
      prefetch_row(stored_row(line + ahead), std::size_t(rect.width) * spec.pixel_bytes());
    const void* stored = stored_row(line);
    if (!is_float)
      OIIO::convert_pixel_values(spec.format, stored, OIIO::TypeFloat, converted.data(),
                                 int(converted.size()));
    const float* pixels = is_float ? static_cast<const float*>(stored) : converted.data();
    float* row = patch.values.data() + line * patch.stride;
    with_channel_count(patch.channels,
                       [&](auto channels) { split_row<channels>(pixels, rect.width, plane, row); });
    for (int channel = 0; channel < patch.channels; ++channel)
      std::fill_n(row + channel * plane + rect.width, PlanarPatch::padding, 0.0f);
  }
}

}  // namespace cps
