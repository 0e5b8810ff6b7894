#include "trainer/images/orientation/measure.h"

#include <algorithm>
#include <cmath>

#include "trainer/images/orientation/tilt_fit.h"

namespace cps {
namespace {

std::int8_t quantised(double value, double steps_per_unit) {
  return static_cast<std::int8_t>(std::lround(value * steps_per_unit));
}

void fill_planes(Orientation& orientation, const EdgeCells& cells, int family) {
  const std::size_t count = pixel_count(cells.grid);
  std::int8_t *tilt = orientation.planes.data() + family * count, *confidence = tilt + edge_families * count;
  const double mean_energy = static_cast<double>(cells.energy) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const EdgeTensor& tensor = cells.families[family][i];
    if (tensor.steep == 0) continue;
    const double steep = static_cast<double>(tensor.steep), weight = steep * coherence(tensor);
    tilt[i] = quantised(static_cast<double>(tensor.product) / steep, tilt_steps_per_unit);
    confidence[i] = quantised(std::sqrt(weight / (weight + mean_energy)), confidence_steps_per_unit);
  }
}

void fill_numbers(OrientationNumbers& numbers, const TiltFit& fit, int family) {
  float* out = numbers.data() + family * numbers_per_family;
  for (double c : fit.coefficients) *out++ = static_cast<float>(c);
  for (double e : fit.errors) *out++ = static_cast<float>(e);
  *out++ = static_cast<float>(fit.share);
  *out = static_cast<float>(fit.residual);
}

}  // namespace

GrayImage measured_picture(const GrayImage& whole, const ImageSize& network_image, int max_width) {
  ImageSize size = reduced_size(whole.size, {.width = std::max(max_width, network_image.width)});
  // Rounding may leave it a row or column short.
  size.width = std::max(size.width, network_image.width);
  size.height = std::max(size.height, network_image.height);
  return area_average(whole, size);
}

Orientation orientation_of(const GrayView& picture, const ImageSize& network_image) {
  const ImageSize grid = orientation_grid(network_image);
  const EdgeCells cells = edge_cells(picture, grid);
  Orientation orientation{.grid = grid, .planes = std::vector<std::int8_t>(plane_bytes(grid))};
  for (int family = 0; family < edge_families; ++family) {
    fill_planes(orientation, cells, family);
    fill_numbers(orientation.numbers, fit_tilt(cells, family), family);
  }
  return orientation;
}

}  // namespace cps
