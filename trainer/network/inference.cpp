#include "trainer/network/inference.h"

#include "trainer/fit/fit_head.h"
#include "trainer/network/orientation_tensors.h"
#include "trainer/network/tensor_batch.h"

namespace cps {
namespace {

/// Calls take(batch, its images, the network's output) for batches that together hold every image once.
template <typename Take>
void for_each_batch(Network& network, std::span<const BatchImage> images, const ModelCard& card, Take take) {
  const torch::NoGradGuard no_gradients;
  network.eval();
  std::vector<ImageSize> sizes;
  for (const BatchImage& image : images) sizes.push_back(image.original);
  for (const Batch& batch : ordered_batches(sizes, card.options.batch_size)) {
    std::vector<BatchImage> members;
    for (int i : batch) members.push_back(images[i]);
    const torch::Device device = network.device();
    take(batch, members,
         network.forward(image_tensor(members, card.pixels).to(device), size_tensor(members).to(device),
                         orientation_tensors(members, card).to(device)));
  }
}

}  // namespace

torch::Tensor run_head(Network& network, std::span<const BatchImage> images, const ModelCard& card) {
  torch::Tensor rows = torch::empty({static_cast<long>(images.size()), row_width(card.options.head)});
  for_each_batch(
      network, images, card,
      [&](const Batch& batch, const std::vector<BatchImage>& members, const NetworkOutput& output) {
        const torch::Tensor predicted = head_rows(output, members, card).cpu();
        for (std::size_t n = 0; n < batch.size(); ++n) rows[batch[n]].copy_(predicted[static_cast<long>(n)]);
      });
  return rows;
}

std::vector<FrameEvidence> run_evidence(Network& network, std::span<const BatchImage> images,
                                        const ModelCard& card) {
  std::vector<FrameEvidence> evidence(images.size());
  for_each_batch(
      network, images, card,
      [&](const Batch& batch, const std::vector<BatchImage>& members, const NetworkOutput& output) {
        std::vector<FrameEvidence> frames = frame_evidence(output, members, card);
        for (std::size_t n = 0; n < batch.size(); ++n) evidence[batch[n]] = std::move(frames[n]);
      });
  return evidence;
}

std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const ModelCard& card) {
  const torch::Tensor rows = run_head(network, images, card);
  const auto numbers = rows.accessor<float, 2>();
  std::vector<Outputs> outputs(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    for (int k = 0; k < output_count; ++k) outputs[i][k] = numbers[static_cast<long>(i)][k];
  return outputs;
}

}  // namespace cps
