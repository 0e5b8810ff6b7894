#include "distortion/warp/noise_kernels.h"

#include <cmath>

#include "distortion/warp/straight_exp.h"

namespace cps {
namespace {

constexpr double pixel_variance = 1.0 / 12, support2 = kernel_support * kernel_support;

double larger(double a, double b) {
  return a > b ? a : b;
}
double smaller(double a, double b) {
  return a < b ? a : b;
}

}  // namespace

// White noise filtered by a Gaussian of variance c along an axis: values one pixel apart have correlation
// exp(−1/4c), and the remaining variance is proportional to 1/√c per axis.

NoiseTarget::NoiseTarget(double sigma_px) : sigma2(sigma_px * sigma_px) {
  constexpr double area = noise_grain_px * noise_grain_px;
  const double variance = sigma2 - area * pixel_variance;
  level = area / variance;
  correlation = std::exp(-0.25 / variance);
}

// Along a principal axis, on which the conic has the eigenvalue e, the picture's kernel has the variance
// 1/(support² e) in source pixels. A source pixel's own 1/12 added, this is σ² times the square of a source
// length per output pixel, which gives 1/c = (1 + support² e / 12) / σ², c in output pixels. The product of
// both axes' (1/source length) · 1/√c is support² √(e₁e₂). Without branches or calls, for vector
// instructions.
void make_noise_kernels(const NoiseTarget& target, const KernelRow& __restrict picture, int count,
                        WeightedKernelRow& __restrict noise) {
  // Near share 1 little noise is added, and no kernel can give an elongated footprint the wanted correlation.
  constexpr double least_correlation = 0.05, most_correlation = 0.9, narrowest_variance = 0.1;
  const double inverse_sigma2 = 1 / target.sigma2, inverse_level = 1 / target.level;
  const double level = target.level, correlation = target.correlation;
  KernelRow& __restrict kernels = noise.kernels;
  for (int i = 0; i < count; ++i) {
    const double conic_xx = picture.conic_xx[i], conic_xy = picture.conic_xy[i],
                 conic_yy = picture.conic_yy[i];
    const double middle = 0.5 * (conic_xx + conic_yy), half_difference = 0.5 * (conic_xx - conic_yy);
    const double reach = std::sqrt(half_difference * half_difference + conic_xy * conic_xy);
    const double e1 = middle + reach, e2 = middle - reach;

    const double share = support2 * std::sqrt(e1 * e2) * inverse_level;
    const double lacking = share < 1 ? 1 - share : 1;
    const double per_lacking = 1 / lacking;
    const auto inverse_variance = [&](double e) {
      return (1 + pixel_variance * support2 * e) * inverse_sigma2;
    };
    const auto added_inverse_variance = [&](double picture_inverse_variance) {
      const double wanted =
          (correlation - share * straight_exp(-0.25 * picture_inverse_variance)) * per_lacking;
      const double possible = smaller(larger(wanted, least_correlation), most_correlation);
      return larger(smaller(-4 * straight_log(possible), 1 / narrowest_variance), picture_inverse_variance);
    };
    const double q1 = inverse_variance(e1), q2 = inverse_variance(e2);
    const double per_q1_q2 = 1 / (q1 * q2);
    const double added1 = e1 * added_inverse_variance(q1) * q2 * per_q1_q2;
    const double added2 = e2 * added_inverse_variance(q2) * q1 * per_q1_q2;

    const double per_root = 1 / std::sqrt(added1 * added2);
    const double mean = 0.5 * (added1 + added2);
    // Where the conic is a circle, any axes will do.
    const double slant = reach > 0 ? 0.5 * (added1 - added2) / reach : 0;
    const double xx = mean + slant * half_difference, yy = mean - slant * half_difference;
    kernels.conic_xx[i] = static_cast<float>(xx);
    kernels.conic_xy[i] = static_cast<float>(slant * conic_xy);
    kernels.conic_yy[i] = static_cast<float>(yy);
    kernels.half_width[i] = static_cast<float>(std::sqrt(yy) * per_root);
    kernels.half_height[i] = static_cast<float>(std::sqrt(xx) * per_root);
    const double weight = std::sqrt(lacking * level * (1 / support2) * per_root);
    noise.weight[i] = static_cast<float>(share < 1 ? weight : 0);
  }
}

}  // namespace cps
