#include "trainer/batch_loss.h"

#include "trainer/losses.h"

namespace cps {
namespace {

torch::Tensor target_tensor(const Samples& samples, const Batch& batch, const std::vector<bool>& mirrored,
                            const Standardisation& by) {
  torch::Tensor tensor = torch::empty({static_cast<long>(batch.size()), output_count});
  float* out = tensor.data_ptr<float>();
  for (std::size_t n = 0; n < batch.size(); ++n) {
    const bool is_mirrored = !mirrored.empty() && mirrored[n];
    for (double v : standardise((is_mirrored ? samples.mirrored_targets : samples.targets)[batch[n]], by))
      *out++ = static_cast<float>(v);
  }
  return tensor;
}

RayBatch ray_batch(const Samples& samples, const Batch& batch, const std::vector<bool>& mirrored) {
  const ImageSize size = samples.cache.originals[batch.front()];
  const long images = static_cast<long>(batch.size()),
             points = static_cast<long>(samples.rays[batch.front()]->pixels.size());
  RayBatch rays{torch::empty({images, points, 2}), torch::empty({images, points, 2}), size.width,
                size.height};
  float *ideal = rays.ideal.data_ptr<float>(), *pixels = rays.pixels.data_ptr<float>();
  for (std::size_t n = 0; n < batch.size(); ++n) {
    const bool is_mirrored = !mirrored.empty() && mirrored[n];
    const RayGrid& grid = *(is_mirrored ? samples.mirrored_rays : samples.rays)[batch[n]];
    for (long i = 0; i < points; ++i)
      for (int axis : {0, 1}) {
        *ideal++ = static_cast<float>(grid.ideal[i][axis]);
        *pixels++ = static_cast<float>(grid.pixels[i][axis]);
      }
  }
  return rays;
}

}  // namespace

torch::Tensor batch_loss(const torch::Tensor& said, const Samples& samples, const Batch& batch,
                         const std::vector<bool>& mirrored, const ModelCard& card) {
  const TrainOptions& options = card.options;
  if (options.loss == Loss::reprojection)
    return reprojection_loss(said, ray_batch(samples, batch, mirrored), options.target_space, card.targets);
  return output_loss(options.loss, said, target_tensor(samples, batch, mirrored, card.targets),
                     output_mask(options));
}

}  // namespace cps
