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

}  // namespace

FrameExposure frame_exposure(const Master& master) {
  constexpr double dim = 0.01, min_share_above_dim = 0.05, max_share_of_white = 0.5;
  const OIIO::ImageBuf& picture = master.light.picture;
  const auto* rgb = static_cast<const float*>(picture.localpixels());
  const auto pixels = static_cast<std::int64_t>(picture.spec().image_pixels());
  std::int64_t above_dim = 0, white = 0;
  for (std::int64_t i = 0; i < pixels; ++i) {
    const double exposed = master.exposure * luminance(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
    above_dim += exposed > dim;
    white += exposed >= 1;
  }
  const auto count = static_cast<double>(pixels);
  if (static_cast<double>(above_dim) < min_share_above_dim * count) return FrameExposure::near_black;
  return static_cast<double>(white) > max_share_of_white * count ? FrameExposure::blown_out
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
