#include "distortion/panorama/spherical_gather.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "distortion/models/straight_angle.h"
#include "distortion/warp/channel_count.h"

namespace cps {
namespace {

using std::numbers::pi;

/// Columns first … last.
struct Columns {
  int first, last;
};

/// The columns that a kernel can reach: one run, or two where it crosses the seam. A second run with
/// last < first is empty.
struct ReachedColumns {
  Columns run, beyond_seam{0, -1};
};

/// A kernel of this reach about a latitude, its centre in the column `centre`. A cap about a pole or one that
/// contains a pole reaches every column; another one Δλ with sin Δλ = sin reach / cos latitude.
ReachedColumns reached_columns(const Panorama& panorama, const SphericalFootprint& footprint,
                               double latitude_rad, double centre) {
  // A little more than the ellipse, so that rounding loses no pixel; those outside get no weight.
  constexpr double margin_px = 1e-6;
  const int width = panorama.width;
  const ReachedColumns all{{0, width - 1}};
  if (std::abs(latitude_rad) + footprint.reach_rad > pi / 2 - 1e-9) return all;
  const double half = std::asin(std::sin(footprint.reach_rad) / footprint.cosine_latitude) / (2 * pi) * width;
  const int first = int(std::ceil(centre - half - margin_px));
  const int last = int(std::floor(centre + half + margin_px));
  if (last - first + 1 >= width) return all;
  if (first < 0) return {{first + width, width - 1}, {0, last}};
  if (last >= width) return {{first, width - 1}, {0, last - width}};
  return {{first, last}};
}

/// One row of the picture, seen from the tangent plane of a footprint: with Δ the difference of longitudes,
/// x = x_per_sine · sin Δ and y = y_per_cosine · cos Δ − y_offset.
struct RowOnPlane {
  double x_per_sine, y_per_cosine, y_offset;
  double share;  ///< of the sphere, of each pixel, up to a factor
};

constexpr int chunk = 64;

/// The kernel's weights of `count` ≤ chunk pixels of a row. Without branches or calls, so that the loop
/// compiles to vector instructions.
void weigh(const SphericalFootprint& footprint, const RowOnPlane& row, int count,
           const double* __restrict sine_longitude, const double* __restrict cosine_longitude,
           double* __restrict weight) {
  const double sine = footprint.sine_longitude, cosine = footprint.cosine_longitude;
  const double xx = footprint.kernel.conic_xx, xy = 2 * footprint.kernel.conic_xy,
               yy = footprint.kernel.conic_yy;
  const RowOnPlane on_plane = row;
  for (int i = 0; i < count; ++i) {
    const double x = on_plane.x_per_sine * (sine_longitude[i] * cosine - cosine_longitude[i] * sine);
    const double cosine_of_difference = cosine_longitude[i] * cosine + sine_longitude[i] * sine;
    const double y = on_plane.y_per_cosine * cosine_of_difference - on_plane.y_offset;
    const double argument = 1 - (xx * x + xy * y) * x - yy * y * y;
    const double inside = argument > 0 ? argument : 0;
    weight[i] = inside * inside * inside * on_plane.share;
  }
}

}  // namespace

SphericalPicture::SphericalPicture(const OIIO::ImageBuf& image)
    : size_{image.spec().width, image.spec().height}, channels_(image.nchannels()) {
  const OIIO::ImageSpec& spec = image.spec();
  if (spec.format != OIIO::TypeFloat) {
    converted_.resize(std::size_t(size_.width) * size_.height * channels_);
    image.get_pixels(image.roi(), OIIO::TypeFloat, converted_.data());
  }
  for (int y = 0; y < size_.height; ++y) {
    rows_.push_back(converted_.empty() ? static_cast<const float*>(image.pixeladdr(spec.x, spec.y + y))
                                       : &converted_[std::size_t(y) * size_.width * channels_]);
    const SineCosine latitude = straight_sine_cosine(latitude_rad(size_, y));
    sine_latitude_.push_back(latitude.sine);
    cosine_latitude_.push_back(latitude.cosine);
  }
  for (int x = 0; x < size_.width; ++x) {
    const SineCosine longitude = straight_sine_cosine(longitude_rad(size_, x));
    sine_longitude_.push_back(longitude.sine);
    cosine_longitude_.push_back(longitude.cosine);
  }
}

template <int channels>
void SphericalPicture::gather_channels(const SphericalFootprint& footprint, float* pixel) const {
  const double latitude = std::atan2(footprint.sine_latitude, footprint.cosine_latitude);
  const double longitude = std::atan2(footprint.sine_longitude, footprint.cosine_longitude);
  const double per_rad = size_.width / (2 * pi);
  const double centre_x = (longitude + pi) * per_rad - 0.5, centre_y = (0.5 * pi - latitude) * per_rad - 0.5;
  const double reach = footprint.reach_rad * per_rad;
  const int first_row = std::max(0, int(std::floor(centre_y - reach)));
  const int last_row = std::min(size_.height - 1, int(std::ceil(centre_y + reach)));
  const ReachedColumns columns = reached_columns(size_, footprint, latitude, centre_x);

  // Sums in double precision, so that the mean of equal values is that value.
  double weights = 0;
  std::array<double, channels> sums{};
  std::array<double, chunk> weight;
  for (int y = first_row; y <= last_row; ++y) {
    const RowOnPlane row{.x_per_sine = per_rad * cosine_latitude_[y],
                         .y_per_cosine = per_rad * cosine_latitude_[y] * footprint.sine_latitude,
                         .y_offset = per_rad * sine_latitude_[y] * footprint.cosine_latitude,
                         .share = cosine_latitude_[y]};
    for (const Columns& run : {columns.run, columns.beyond_seam})
      for (int x = run.first; x <= run.last; x += chunk) {
        const int count = std::min(chunk, run.last - x + 1);
        weigh(footprint, row, count, &sine_longitude_[x], &cosine_longitude_[x], weight.data());
        const float* values = rows_[y] + std::size_t(x) * channels;
        for (int i = 0; i < count; ++i) {
          weights += weight[i];
          for (int channel = 0; channel < channels; ++channel)
            sums[channel] += weight[i] * values[i * channels + channel];
        }
      }
  }
  for (int channel = 0; channel < channels; ++channel) pixel[channel] = float(sums[channel] / weights);
}

void SphericalPicture::gather(const SphericalFootprint& footprint, float* pixel) const {
  with_channel_count(channels_, [&](auto channels) { gather_channels<channels>(footprint, pixel); });
}

}  // namespace cps
