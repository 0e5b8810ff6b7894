#include "trainer/training/losses.h"

#include <ATen/ATen.h>

#include <algorithm>
#include <cmath>

#include "numbers/angles.h"

namespace cps {

using torch::Tensor;

Tensor output_mask(const TrainOptions& options) {
  Tensor mask = torch::zeros({output_count});
  for (int i = 0; i < output_count; ++i)
    if (std::ranges::find(options.outputs, output_names[i]) != options.outputs.end()) mask[i] = 1;
  return mask;
}

Tensor output_loss(Loss loss, const Tensor& predicted, const Tensor& truth, const Tensor& learned) {
  const Tensor targets = truth.to(predicted.device()), mask = learned.to(predicted.device());
  const Tensor each = loss == Loss::huber ? torch::huber_loss(predicted, targets, at::Reduction::None, 1.0)
                                          : (predicted - targets).square();
  return (each * mask).sum() / (mask.sum() * predicted.size(0));
}

Tensor reprojection_loss(const Tensor& predicted, const RayBatch& rays, TargetSpace space,
                         const Standardisation& by) {
  const auto numbers = [&](const Outputs& values) {
    return torch::tensor(std::vector<double>(values.begin(), values.end()), torch::kDouble)
        .to(predicted.options());
  };
  const Tensor outputs = predicted * numbers(by.deviation) + numbers(by.mean);
  const auto output = [&](int i) { return outputs.select(1, i).unsqueeze(1); };  // [n, 1]
  const double one_degree = radians(1);
  const Tensor half_tangent = (output(0).clamp(one_degree, radians(179)) / 2).tan();

  Tensor k1 = output(1), k2 = output(2), k3 = output(3), p1 = output(4), p2 = output(5);
  if (space == TargetSpace::apparent) {
    const Tensor r = half_tangent * std::hypot(1.0, static_cast<double>(rays.height) / rays.width),
                 r2 = r * r;
    k1 = k1 / r2;
    k2 = k2 / (r2 * r2);
    k3 = k3 / (r2 * r2 * r2);
    p1 = p1 / r;
    p2 = p2 / r;
  }
  const Tensor ideal = rays.ideal.to(predicted.device()), pixels = rays.pixels.to(predicted.device());
  const Tensor x = ideal.select(2, 0), y = ideal.select(2, 1), s = x * x + y * y;
  const Tensor stretch =
      1 + s * (k1 + s * (k2 + s * k3)) + 2 * (p2 * x + p1 * y);  // evaluated like distort()
  const Tensor focal = rays.width / (2 * half_tangent);
  const Tensor dx = focal * (x * stretch + p2 * s) + output(6) * rays.width - pixels.select(2, 0),
               dy = focal * (y * stretch + p1 * s) + output(7) * rays.height - pixels.select(2, 1);
  // The tiny term keeps the square root's slope finite where the prediction is exact.
  return (dx.square() + dy.square() + 1e-12).sqrt().mean() * (100.0 / rays.width);
}

}  // namespace cps
