#include "trainer/network/edges.h"

#include <ATen/ATen.h>

namespace cps {

torch::Tensor sobel_kernels() {
  const torch::Tensor smooth = torch::tensor({1.f, 2.f, 1.f}) / 4,
                      slope = torch::tensor({-1.f, 0.f, 1.f}) / 2;
  return torch::stack({torch::outer(smooth, slope), torch::outer(slope, smooth)}).unsqueeze(1);
}

torch::Tensor with_sobel_edges(const torch::Tensor& images) {
  const torch::Tensor gradient =
      at::conv2d(at::replication_pad2d(images, {1, 1, 1, 1}), sobel_kernels().to(images.options()));
  return at::cat({images, gradient.square().sum(1, true).sqrt()}, 1);
}

}  // namespace cps
