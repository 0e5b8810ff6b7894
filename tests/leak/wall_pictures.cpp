#include "tests/leak/wall_pictures.h"

#include <OpenImageIO/imagebufalgo.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "distortion/inverse/inverse_map.h"
#include "distortion/warp/master_camera.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"
#include "sensor/photograph.h"

namespace cps {
namespace {

constexpr int width_px = 128, height_px = 72;
constexpr double base_hfov_deg[] = {50, 70, 90, 110, 130};

/// An 8-bit picture of the base's size looked up between four of its pixels, and rounded again.
OIIO::ImageBuf bilinear(const OIIO::ImageBuf& picture, const Pinhole& source, const DrawnLens& lens) {
  OIIO::ImageBuf image(OIIO::ImageSpec(width_px, height_px, 3, OIIO::TypeUInt8));
  const auto tile = std::make_unique<InverseMapTile>();
  constexpr int side = InverseMapTile::side;
  for (int y0 = 0; y0 < height_px; y0 += side)
    for (int x0 = 0; x0 < width_px; x0 += side) {
      const int width = std::min(side, width_px - x0), height = std::min(side, height_px - y0);
      invert_tile(lens.distortion, frame_on_plane(lens.base), lens.crop.camera, {x0, y0, width, height},
                  *tile);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const int index = tile->index(x, y);
          float pixel[3];
          // interppixel puts pixel centres at .5.
          picture.interppixel(float(source.fx * tile->x[index] + source.cx + 0.5),
                              float(source.fy * tile->y[index] + source.cy + 0.5), pixel,
                              OIIO::ImageBuf::WrapClamp);
          for (float& value : pixel) value = std::round(value * 255) / 255;
          image.setpixel(x0 + x, y0 + y, pixel);
        }
    }
  return image;
}

OIIO::ImageBuf picture_of(const NoiseWall& wall, Resampler resampler, const DrawnLens& lens, double exposure,
                          const Sensor& sensor, Stream place) {
  if (resampler == Resampler::bilinear_8bit) {
    const NoisyMaster master = cut_master(wall, width_px, height_px, place);
    return bilinear(develop(master.picture, exposure, sensor.settings, sensor.noise), lens.base, lens);
  }
  const Pinhole camera = master_camera(lens.base, {}, LensBounds{}.min_eigenvalue);
  Master master{
      .camera = camera, .light = cut_master(wall, camera.width, camera.height, place), .exposure = exposure};
  // Without known noise nothing is added to even it out.
  if (resampler == Resampler::unguarded) OIIO::ImageBufAlgo::zero(master.light.noise);
  return photograph(master, cropped(lens), sensor, PixelFormat::rgb);
}

std::array<double, secret_count> secrets_of(const DrawnLens& lens) {
  const double half_diagonal = 0.5 * frame_on_plane(lens.base).diagonal().norm();
  const double hfov_deg = degrees(hfov_rad(lens.crop.camera));
  return {rescaled(lens.distortion, half_diagonal).k1, hfov_deg, degrees(hfov_rad(lens.base)) - hfov_deg};
}

}  // namespace

WallPictures photograph_wall(const NoiseWall& wall, Resampler resampler, int count, Stream stream) {
  WallPictures pictures{.width = width_px, .height = height_px, .pixels = {}, .secrets = {}};
  constexpr std::size_t size = std::size_t(width_px) * height_px;
  pictures.pixels.resize(size * count);
  pictures.secrets.resize(count);
  const double exposure = meter_exposure(wall.master.picture);
  tbb::parallel_for(0, count, [&](int i) {
    const Stream own = substream(stream, i);
    const Pinhole base = pinhole_from_hfov(width_px, height_px, radians(base_hfov_deg[i % 5]));
    LensOptions lenses;
    lenses.scheme = LensScheme::shape_prior;
    const DrawnLens lens = draw_lens(base, CropOrder::base_first, lenses, make_stream(own.key, "lens"));
    const OIIO::ImageBuf image =
        picture_of(wall, resampler, lens, exposure, sensor_of({}, own), make_stream(own.key, "place"));
    const auto* rgb = static_cast<const std::uint8_t*>(image.localpixels());
    for (std::size_t p = 0; p < size; ++p)
      pictures.pixels[i * size + p] =
          std::uint8_t(std::lround(0.2126 * rgb[3 * p] + 0.7152 * rgb[3 * p + 1] + 0.0722 * rgb[3 * p + 2]));
    pictures.secrets[i] = secrets_of(lens);
  });
  return pictures;
}

}  // namespace cps
