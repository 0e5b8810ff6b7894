#include "trainer/network/edges.h"

#include <ATen/ATen.h>

namespace cps {

torch::Tensor with_sobel_edges(const torch::Tensor& images) {
  const torch::Tensor smooth = torch::tensor({1.f, 2.f, 1.f}) / 4,
                      slope = torch::tensor({-1.f, 0.f, 1.f}) / 2;
  const torch::Tensor kernels = torch::stack({torch::outer(smooth, slope), torch::outer(slope, smooth)})
                                    .unsqueeze(1)
                                    .to(images.options());
  const torch::Tensor gradient = at::conv2d(at::replication_pad2d(images, {1, 1, 1, 1}), kernels);
  return at::cat({images, gradient.square().sum(1, true).sqrt()}, 1);
}

}  // namespace cps
