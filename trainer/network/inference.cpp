#include "trainer/network/inference.h"

#include "trainer/images/batches.h"

namespace cps {

std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const PixelStatistics& statistics, int batch_size) {
  const torch::NoGradGuard no_gradients;
  network.eval();
  std::vector<ImageSize> sizes;
  for (const BatchImage& image : images) sizes.push_back(image.original);
  std::vector<Outputs> outputs(images.size());
  for (const Batch& batch : ordered_batches(sizes, batch_size)) {
    std::vector<BatchImage> members;
    for (int i : batch) members.push_back(images[i]);
    const torch::Tensor predicted = network
                                        .forward(image_tensor(members, statistics).to(network.device()),
                                                 size_tensor(members).to(network.device()))
                                        .cpu();
    const auto rows = predicted.accessor<float, 2>();
    for (std::size_t n = 0; n < batch.size(); ++n)
      for (int k = 0; k < output_count; ++k) outputs[batch[n]][k] = rows[n][k];
  }
  return outputs;
}

}  // namespace cps
