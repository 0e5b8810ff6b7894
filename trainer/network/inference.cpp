#include "trainer/network/inference.h"

#include "trainer/network/orientation_tensors.h"
#include "trainer/network/tensor_batch.h"

namespace cps {

torch::Tensor run_last_layer(Network& network, std::span<const BatchImage> images, const ModelCard& card) {
  const torch::NoGradGuard no_gradients;
  network.eval();
  std::vector<ImageSize> sizes;
  for (const BatchImage& image : images) sizes.push_back(image.original);
  torch::Tensor rows = torch::empty({static_cast<long>(images.size()), unit_count(card.options.head)});
  for (const Batch& batch : ordered_batches(sizes, card.options.batch_size)) {
    std::vector<BatchImage> members;
    for (int i : batch) members.push_back(images[i]);
    const torch::Device device = network.device();
    const torch::Tensor predicted =
        network
            .forward(image_tensor(members, card.pixels).to(device), size_tensor(members).to(device),
                     orientation_tensors(members, card).to(device))
            .cpu();
    for (std::size_t n = 0; n < batch.size(); ++n) rows[batch[n]].copy_(predicted[static_cast<long>(n)]);
  }
  return rows;
}

std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const ModelCard& card) {
  const torch::Tensor rows = run_last_layer(network, images, card);
  const auto numbers = rows.accessor<float, 2>();
  std::vector<Outputs> outputs(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    for (int k = 0; k < output_count; ++k) outputs[i][k] = numbers[static_cast<long>(i)][k];
  return outputs;
}

}  // namespace cps
