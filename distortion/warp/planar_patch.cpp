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
  for (int line = 0; line < rect.height; ++line) {
    const void* stored = image.pixeladdr(spec.x + rect.x0, spec.y + rect.y0 + line);
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
