#include "trainer/network/inference.h"

#include "trainer/network/orientation_tensors.h"
#include "trainer/network/tensor_batch.h"

namespace cps {

std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const ModelCard& card) {
  const torch::NoGradGuard no_gradients;
  network.eval();
  std::vector<ImageSize> sizes;
  for (const BatchImage& image : images) sizes.push_back(image.original);
  std::vector<Outputs> outputs(images.size());
  for (const Batch& batch : ordered_batches(sizes, card.options.batch_size)) {
    std::vector<BatchImage> members;
    for (int i : batch) members.push_back(images[i]);
    const torch::Device device = network.device();
    const torch::Tensor predicted =
        network
            .forward(image_tensor(members, card.pixels).to(device), size_tensor(members).to(device),
                     orientation_tensors(members, card).to(device))
            .cpu();
    const auto rows = predicted.accessor<float, 2>();
    for (std::size_t n = 0; n < batch.size(); ++n)
      for (int k = 0; k < output_count; ++k) outputs[batch[n]][k] = rows[n][k];
  }
  return outputs;
}

}  // namespace cps
