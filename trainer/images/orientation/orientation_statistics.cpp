#include "trainer/images/orientation/orientation_statistics.h"

#include <algorithm>
#include <cmath>

namespace cps {
namespace {

struct Sums {
  std::int64_t sum = 0, squares = 0;  // whole numbers: exact in any order

  void add(std::int64_t value) {
    sum += value;
    squares += value * value;
  }
};

double usable(double variance) {
  const double deviation = std::sqrt(std::max(0.0, variance));
  return deviation > 1e-6 ? deviation : 1;
}

void set_planes(OrientationStatistics& result, std::span<const OrientationView> images) {
  std::array<Sums, orientation_plane_count> sums;
  std::int64_t cells = 0;
  for (const OrientationView& image : images) {
    const std::int64_t count = std::int64_t{image.grid.width} * image.grid.height;
    cells += count;
    for (int family = 0; family < edge_families; ++family) {
      const std::int8_t *tilt = image.planes + family * count, *confidence = tilt + edge_families * count;
      for (std::int64_t i = 0; i < count; ++i) {
        sums[family].add(tilt[i] * confidence[i]);
        sums[edge_families + family].add(confidence[i]);
      }
    }
  }
  for (int i = 0; i < orientation_plane_count; ++i) {
    const double unit = confidence_steps_per_unit * (i < edge_families ? tilt_steps_per_unit : 1);
    const double n = static_cast<double>(cells), mean = static_cast<double>(sums[i].sum) / n / unit;
    result.plane_mean[i] = mean;
    result.plane_deviation[i] =
        usable(static_cast<double>(sums[i].squares) / n / (unit * unit) - mean * mean);
  }
}

void set_numbers(OrientationStatistics& result, std::span<const OrientationView> images) {
  const double n = static_cast<double>(images.size());
  for (int i = 0; i < orientation_number_count; ++i) {
    double sum = 0, squares = 0;
    for (const OrientationView& image : images) sum += image.numbers[i];
    const double mean = sum / n;
    for (const OrientationView& image : images)
      squares += (image.numbers[i] - mean) * (image.numbers[i] - mean);
    result.number_mean[i] = mean;
    result.number_deviation[i] = usable(squares / n);
  }
}

}  // namespace

OrientationStatistics orientation_statistics(std::span<const OrientationView> images) {
  OrientationStatistics result;
  set_planes(result, images);
  set_numbers(result, images);
  return result;
}

}  // namespace cps
