#include "renderer/camera_mask.h"

#include "renderer/camera_rays.h"
#include "renderer/tiles.h"

namespace cps {
namespace {

/// What a lens shows is a disc, an ellipse or the image of a rectangle, much larger than a pixel: corners and
/// middles of the sides tell.
bool sees_rim(const CameraRays& rays, const CameraPixel& pixel) {
  for (const float x : {-0.5f, 0.0f, 0.5f})
    for (const float y : {-0.5f, 0.0f, 0.5f})
      if (!camera_ray(rays, pixel, {x, y}).is_seen) return false;
  return true;
}

}  // namespace

OIIO::ImageBuf seen_pixels(const Camera& camera) {
  const CameraRays rays = make_camera_rays(camera, PixelFilter::box);
  const int width = camera.pinhole.width, height = camera.pinhole.height;
  OIIO::ImageBuf mask(OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT8));
  auto* values = static_cast<unsigned char*>(mask.localpixels());
  for_each_tile(width, height, [&](const Tile& tile) {
    for (int i = 0; i < Tile::pixels; ++i) {
      const TilePixel at = tile_pixel(tile, i);
      if (at.x >= width || at.y >= height) continue;
      values[static_cast<std::size_t>(at.y) * width + at.x] =
          sees_rim(rays, camera_pixel(rays, at.x, at.y)) ? 255 : 0;
    }
  });
  return mask;
}

}  // namespace cps
