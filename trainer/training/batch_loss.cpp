#include "trainer/training/batch_loss.h"

#include "trainer/deepcalib/sphere_head.h"
#include "trainer/fit/fit_head.h"
#include "trainer/training/losses.h"

namespace cps {
namespace {

torch::Tensor target_tensor(const BatchTruth& truth, const Standardisation& by) {
  torch::Tensor tensor = torch::empty({static_cast<long>(truth.targets.size()), output_count});
  float* out = tensor.data_ptr<float>();
  for (const Outputs& target : truth.targets)
    for (double v : standardise(target, by)) *out++ = static_cast<float>(v);
  return tensor;
}

RayBatch ray_batch(const BatchTruth& truth) {
  const long images = static_cast<long>(truth.rays.size()),
             points = static_cast<long>(truth.rays.front()->pixels.size());
  RayBatch rays{torch::empty({images, points, 2}), torch::empty({images, points, 2}), truth.size.width,
                truth.size.height};
  float *ideal = rays.ideal.data_ptr<float>(), *pixels = rays.pixels.data_ptr<float>();
  for (const auto& grid : truth.rays)
    for (long i = 0; i < points; ++i)
      for (int axis : {0, 1}) {
        *ideal++ = static_cast<float>(grid->ideal[i][axis]);
        *pixels++ = static_cast<float>(grid->pixels[i][axis]);
      }
  return rays;
}

}  // namespace

torch::Tensor batch_loss(const torch::Tensor& predicted, const BatchTruth& truth, const ModelCard& card) {
  const TrainOptions& options = card.options;
  if (is_deepcalib(options.head)) return sphere_loss(options.head, predicted, truth.spheres);
  if (options.loss == Loss::reprojection)
    return reprojection_loss(predicted, ray_batch(truth), options.target_space, card.targets);
  const torch::Tensor targets = target_tensor(truth, card.targets);
  if (!is_fit(options.head)) return output_loss(options.loss, predicted, targets, output_mask(options));
  return output_loss(options.loss, predicted.narrow(1, 0, output_count), targets, output_mask(options)) +
         likelihood_loss(predicted, targets) + folding_penalty(predicted, truth.targets, card.targets);
}

}  // namespace cps
