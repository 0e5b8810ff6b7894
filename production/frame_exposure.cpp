#include "production/frame_exposure.h"

#include <fmt/format.h>

#include <algorithm>

#include "numbers/luminance.h"

namespace cps {
namespace {

std::string warning(const std::vector<std::string>& views, const char* fault) {
  return fmt::format(
      "warning: {} {} {}, the first: {}; look at its image, and at the scene's lights and materials",
      views.size(), views.size() == 1 ? "view is" : "views are", fault, std::ranges::min(views));
}

/// Numbers of pixels.
struct ExposedPixels {
  std::int64_t count = 0, above_dim = 0, white = 0;

  /// Adds the valid pixels of an image.
  void add(const MeteredImage& image, double exposure) {
    constexpr double dim = 0.01;
    const auto* rgb = static_cast<const float*>(image.linear->localpixels());
    const auto* valid = image.valid ? static_cast<const std::uint8_t*>(image.valid->localpixels()) : nullptr;
    const auto pixels = static_cast<std::int64_t>(image.linear->spec().image_pixels());
    for (std::int64_t i = 0; i < pixels; ++i) {
      if (valid && valid[i] == 0) continue;
      const double exposed = exposure * luminance(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
      ++count;
      above_dim += exposed > dim;
      white += exposed >= 1;
    }
  }
};

}  // namespace

FrameExposure frame_exposure(const Master& master) {
  const MeteredImage image{&master.light.picture};
  return frame_exposure(std::span(&image, 1), master.exposure);
}

FrameExposure frame_exposure(std::span<const MeteredImage> images, double exposure) {
  constexpr double min_share_above_dim = 0.05, max_share_of_white = 0.5;
  ExposedPixels pixels;
  for (const MeteredImage& image : images) pixels.add(image, exposure);
  const auto count = static_cast<double>(pixels.count);
  if (static_cast<double>(pixels.above_dim) < min_share_above_dim * count) return FrameExposure::near_black;
  return static_cast<double>(pixels.white) > max_share_of_white * count ? FrameExposure::blown_out
                                                                        : FrameExposure::good;
}

void BadlyExposed::add(FrameExposure exposure, const std::string& view) {
  if (exposure == FrameExposure::near_black) near_black.push_back(view);
  if (exposure == FrameExposure::blown_out) blown_out.push_back(view);
}

std::vector<std::string> BadlyExposed::warnings() const {
  std::vector<std::string> lines;
  if (!near_black.empty()) lines.push_back(warning(near_black, "nearly black"));
  if (!blown_out.empty()) lines.push_back(warning(blown_out, "mostly white"));
  return lines;
}

}  // namespace cps
