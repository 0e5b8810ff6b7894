#include "trainer/network/tensor_batch.h"

#include <algorithm>

namespace cps {

torch::Tensor image_tensor(std::span<const BatchImage> images, const PixelStatistics& statistics) {
  const ImageSize size = images.front().gray.size;
  torch::Tensor tensor = torch::empty({static_cast<long>(images.size()), 1, size.height, size.width});
  float* out = tensor.data_ptr<float>();
  const float scale = static_cast<float>(1 / statistics.deviation),
              mean = static_cast<float>(statistics.mean);
  for (const BatchImage& image : images)
    for (int y = 0; y < size.height; ++y, out += size.width) {
      const std::uint8_t* row = image.gray.pixels + static_cast<std::size_t>(y) * size.width;
      for (int x = 0; x < size.width; ++x) out[x] = (row[x] - mean) * scale;
      if (image.mirror) std::reverse(out, out + size.width);
    }
  return tensor;
}

torch::Tensor size_tensor(std::span<const BatchImage> images) {
  torch::Tensor tensor = torch::empty({static_cast<long>(images.size()), 2});
  float* out = tensor.data_ptr<float>();
  for (const BatchImage& image : images) {
    *out++ = static_cast<float>(image.original.height / double{size_unit.height});
    *out++ = static_cast<float>(image.original.width / double{size_unit.width});
  }
  return tensor;
}

}  // namespace cps
