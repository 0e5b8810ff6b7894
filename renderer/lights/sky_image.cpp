#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <stdexcept>

#include "renderer/lights/sky_models.h"

namespace cps {
namespace {

constexpr int max_columns = 8192, max_rows = 4096;

[[noreturn]] void refuse(const Daylight& daylight, const std::string& what) {
  throw std::runtime_error(daylight.sky_image.string() + ": " + what);
}

/// Three float channels, or one repeated.
OIIO::ImageBuf read_picture(const Daylight& daylight) {
  OIIO::ImageBuf picture(daylight.sky_image.string());
  if (!picture.init_spec(daylight.sky_image.string(), 0, 0))
    refuse(daylight, "cannot be read as a picture of the sky: " + picture.geterror());
  const OIIO::ImageSpec& spec = picture.spec();
  if (spec.width < 2 || spec.height < 2 || spec.width > max_columns || spec.height > max_rows || spec.deep)
    refuse(daylight, "is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                         ": a picture of the sky may be 2x2 to 8192x4096");
  if (!picture.read(0, 0, true, OIIO::TypeDesc::FLOAT)) refuse(daylight, picture.geterror());
  const int gray[] = {0, 0, 0}, rgb[] = {0, 1, 2};
  return OIIO::ImageBufAlgo::channels(picture, 3, spec.nchannels < 3 ? gray : rgb);
}

}  // namespace

Sky make_image_sky(const Daylight& daylight) {
  const OIIO::ImageBuf picture = read_picture(daylight);
  const int columns = picture.spec().width, rows = picture.spec().height;
  const auto* texels = static_cast<const float*>(picture.localpixels());
  const auto texel = [&](int column, int row_from_top) {
    const Color value = Eigen::Map<const Color>(
        texels + 3 * (static_cast<std::size_t>(row_from_top) * columns + (column + columns) % columns));
    if (!value.allFinite()) refuse(daylight, "holds a value that is not finite");
    return Color(value.max(0.0f) * static_cast<float>(daylight.sky_image_scale));
  };

  Sky sky = make_empty_sky(columns, rows, Rows::even_in_elevation);
  // The table's first column lies at +x, a quarter turn clockwise of north; the picture's middle at its
  // azimuth.
  const double turns = 0.25 - daylight.sky_image_azimuth_deg / 360 + 0.5;
  const double shift = (turns - std::floor(turns)) * columns;
  const int whole = static_cast<int>(shift);
  const auto fraction = static_cast<float>(shift - whole);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int from = column + whole;
      Color radiance = texel(from, rows - 1 - row);
      if (fraction > 0.0f) radiance += fraction * (texel(from + 1, rows - 1 - row) - radiance);
      set_cell(sky, column, row, radiance);
    }
  }
  sky.distribution = make_sky_distribution(sky);
  return sky;
}

}  // namespace cps
