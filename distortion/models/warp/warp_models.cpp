#include "distortion/models/warp/warp_models.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "distortion/models/warp/model_footprints.h"
#include "distortion/warp/pixel_bounds.h"
#include "distortion/warp/resample.h"
#include "distortion/warp/tiles.h"
#include "distortion/warp/warp_checks.h"

namespace cps {

OIIO::ImageBuf warp_between(const OIIO::ImageBuf& source, const ModelCamera& source_camera,
                            const ModelCamera& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(source, source_camera.pinhole, output.pinhole, options);
  const ProvedCamera from = proved_camera(source_camera), to = proved_camera(output);
  const Footprints footprints = [&](const TileRect& rect, FootprintTile& tile) {
    model_footprints(from, to, options.kernel_sigma_px, rect, tile);
  };
  return resample(source, nullptr, output.pinhole, options, footprints, summary);
}

OIIO::ImageBuf valid_pixels(const ModelCamera& source_camera, const ModelCamera& output,
                            const WarpOptions& options) {
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error("warp: " + fault);
  const ProvedCamera from = proved_camera(source_camera), to = proved_camera(output);
  const Pinhole &seen = source_camera.pinhole, &shown = output.pinhole;
  OIIO::ImageBuf image(OIIO::ImageSpec(shown.width, shown.height, 1, OIIO::TypeUInt8));
  for_each_tile(shown.width, shown.height, [&](const TileRect& rect) {
    const auto tile = std::make_unique_for_overwrite<FootprintTile>();
    model_footprints(from, to, options.kernel_sigma_px, rect, *tile);
    BoundsRow bounds;
    for (int row = 0; row < rect.height; ++row) {
      find_bounds(*tile, row, seen.width, seen.height, bounds);
      auto* pixels = static_cast<std::uint8_t*>(image.pixeladdr(rect.x0, rect.y0 + row));
      for (int i = 0; i < rect.width; ++i) {
        const double x = tile->x[row * FootprintTile::side + i], y = tile->y[row * FootprintTile::side + i];
        const bool is_inside = x >= -0.5 && x < seen.width - 0.5 && y >= -0.5 && y < seen.height - 0.5;
        const bool has_footprint = bounds.x0[i] >= 0;
        pixels[i] = (options.resampling == Resampling::footprint ? has_footprint : is_inside) ? 255 : 0;
      }
    }
  });
  return image;
}

}  // namespace cps
