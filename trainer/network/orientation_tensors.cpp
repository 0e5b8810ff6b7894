#include "trainer/network/orientation_tensors.h"

#include <algorithm>

#include "trainer/model/model_card.h"

namespace cps {
namespace {

/// A channel's float for each whole number of its plane.
struct Normalisation {
  float mean, scale;

  Normalisation(double unit, double mean_value, double deviation)
      : mean(static_cast<float>(mean_value * unit)), scale(static_cast<float>(1 / (unit * deviation))) {}
  float operator()(int steps) const { return (static_cast<float>(steps) - mean) * scale; }
};

void flip_rows(float* plane, const ImageSize& grid) {
  for (int y = 0; y < grid.height; ++y, plane += grid.width) std::reverse(plane, plane + grid.width);
}

void fill_planes(float* out, const BatchImage& image, const OrientationStatistics& by) {
  const ImageSize& grid = image.orientation.grid;
  const std::size_t cells = static_cast<std::size_t>(grid.width) * grid.height;
  const int sign = image.mirror ? -1 : 1;
  for (int family = 0; family < edge_families; ++family) {
    const int other = edge_families + family;
    const Normalisation tilts(tilt_steps_per_unit * confidence_steps_per_unit, by.plane_mean[family],
                              by.plane_deviation[family]),
        confidences(confidence_steps_per_unit, by.plane_mean[other], by.plane_deviation[other]);
    const std::int8_t *tilt = image.orientation.planes + family * cells,
                      *confidence = image.orientation.planes + other * cells;
    float *tilt_out = out + family * cells, *confidence_out = out + other * cells;
    for (std::size_t i = 0; i < cells; ++i) {
      tilt_out[i] = tilts(sign * tilt[i] * confidence[i]);
      confidence_out[i] = confidences(confidence[i]);
    }
    if (!image.mirror) continue;
    flip_rows(tilt_out, grid);
    flip_rows(confidence_out, grid);
  }
}

void fill_numbers(float* out, const BatchImage& image, const OrientationStatistics& by) {
  const OrientationNumbers numbers =
      image.mirror ? mirrored(image.orientation.numbers) : image.orientation.numbers;
  for (int i = 0; i < orientation_number_count; ++i)
    out[i] = static_cast<float>((numbers[i] - by.number_mean[i]) / by.number_deviation[i]);
}

}  // namespace

OrientationTensors OrientationTensors::to(torch::Device device) const {
  if (!planes.defined()) return {};
  return {planes.to(device), numbers.to(device)};
}

OrientationTensors orientation_tensors(std::span<const BatchImage> images, const ModelCard& card) {
  if (!card.options.orientation.measured) return {};
  const long count = static_cast<long>(images.size());
  const ImageSize grid = images.front().orientation.grid;
  const OrientationTensors tensors{torch::empty({count, orientation_plane_count, grid.height, grid.width}),
                                   torch::empty({count, orientation_number_count})};
  float *planes = tensors.planes.data_ptr<float>(), *numbers = tensors.numbers.data_ptr<float>();
  for (const BatchImage& image : images) {
    fill_planes(planes, image, card.orientation);
    fill_numbers(numbers, image, card.orientation);
    planes += plane_bytes(grid);  // one number for each byte
    numbers += orientation_number_count;
  }
  return tensors;
}

}  // namespace cps
