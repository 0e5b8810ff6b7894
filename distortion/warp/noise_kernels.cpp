#include "distortion/warp/noise_kernels.h"

#include <array>
#include <cmath>

#include "distortion/warp/straight_exp.h"

namespace cps {
namespace {

constexpr double support2 = kernel_support * kernel_support;

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

namespace {

// Near full share little noise is added, and no kernel can give an elongated footprint the wanted
// correlation.
constexpr double least_correlation = 0.05, most_correlation = 0.9, narrowest_variance = 0.1;

using Doubles = std::array<double, KernelRow::side>;

/// Principal axes of a row of conics, and what is known along each of the two (the first index).
///
/// Where a conic has the eigenvalue e, the picture's kernel has the variance 1/(support² e) in source pixels.
/// A source pixel's own 1/12 added, this is σ² times the square of a source length per output pixel, which
/// gives 1/c = (1 + support² e / 12) / σ², c in output pixels. The product over both axes of 1/(source length
/// · √c), the noise's level, is support² √(e₁e₂).
struct Axes {
  alignas(32) Doubles half_difference, per_reach;  ///< of xx and yy; 1 / (half difference of the eigenvalues)
  alignas(32) Doubles share, lacking, per_lacking;  ///< of the wanted level: present, missing, 1/missing
  alignas(32) std::array<Doubles, 2> eigenvalue;    ///< of the picture's conic, then of the noise's
  alignas(32) std::array<Doubles, 2> inverse_variance, per_inverse_variance;  ///< 1/c and c
};

// The loops have no branches or calls, so that they compile to vector instructions, and are short, so that
// the processor works on several turns at once. A division is slow, so reciprocals are taken of products.

void find_axes(const NoiseTarget& target, const KernelRow& __restrict picture, int count,
               Axes& __restrict axes) {
  const double inverse_sigma2 = 1 / target.sigma2, per_level = support2 / target.level;
  for (int i = 0; i < count; ++i) {
    const double xx = picture.conic_xx[i], xy = picture.conic_xy[i], yy = picture.conic_yy[i];
    const double middle = 0.5 * (xx + yy), half_difference = 0.5 * (xx - yy);
    const double reach = std::sqrt(half_difference * half_difference + xy * xy);
    const double e1 = middle + reach, e2 = middle - reach;
    const double share = per_level * std::sqrt(e1 * e2);
    const double lacking = share < 1 ? 1 - share : 1;
    const double q1 = (1 + pixel_variance * support2 * e1) * inverse_sigma2;
    const double q2 = (1 + pixel_variance * support2 * e2) * inverse_sigma2;
    // Where the conic is a circle, any axes will do.
    const double divisible_reach = reach > 0 ? reach : 1;
    const double q1_q2 = q1 * q2, rest = lacking * divisible_reach;
    const double reciprocal = 1 / (q1_q2 * rest);
    axes.half_difference[i] = half_difference;
    axes.per_reach[i] = reciprocal * q1_q2 * lacking;
    axes.share[i] = share;
    axes.lacking[i] = lacking;
    axes.per_lacking[i] = reciprocal * q1_q2 * divisible_reach;
    axes.eigenvalue[0][i] = e1;
    axes.eigenvalue[1][i] = e2;
    axes.inverse_variance[0][i] = q1;
    axes.inverse_variance[1][i] = q2;
    axes.per_inverse_variance[0][i] = reciprocal * rest * q2;
    axes.per_inverse_variance[1][i] = reciprocal * rest * q1;
  }
}

/// Correlation of neighbours along one axis that the noise to add should have.
void find_correlations(double wanted, int count, const Doubles& __restrict share,
                       const Doubles& __restrict per_lacking, const Doubles& __restrict inverse_variance,
                       Doubles& __restrict correlation) {
  for (int i = 0; i < count; ++i) {
    const double ideal = (wanted - share[i] * straight_exp(-0.25 * inverse_variance[i])) * per_lacking[i];
    correlation[i] = larger(ideal, least_correlation);
  }
}

/// Turns eigenvalues of the picture's conics along one axis into those of the noise's.
void change_eigenvalues(int count, const Doubles& __restrict correlation,
                        const Doubles& __restrict inverse_variance,
                        const Doubles& __restrict per_inverse_variance, Doubles& __restrict eigenvalue) {
  const double least = -4 * std::log(most_correlation);
  for (int i = 0; i < count; ++i) {
    const double ideal = larger(-4 * straight_log(correlation[i]), least);
    const double added = larger(smaller(ideal, 1 / narrowest_variance), inverse_variance[i]);
    eigenvalue[i] = eigenvalue[i] * added * per_inverse_variance[i];
  }
}

void set_kernels(const NoiseTarget& target, const KernelRow& __restrict picture, const Axes& __restrict axes,
                 int count, WeightedKernelRow& __restrict noise) {
  const double to_weight = target.level / support2;
  KernelRow& __restrict kernels = noise.kernels;
  for (int i = 0; i < count; ++i) {
    const double e1 = axes.eigenvalue[0][i], e2 = axes.eigenvalue[1][i];
    const double per_root = 1 / std::sqrt(e1 * e2);
    const double mean = 0.5 * (e1 + e2), slant = 0.5 * (e1 - e2) * axes.per_reach[i];
    const double xx = mean + slant * axes.half_difference[i], yy = mean - slant * axes.half_difference[i];
    kernels.conic_xx[i] = static_cast<float>(xx);
    kernels.conic_xy[i] = static_cast<float>(slant * picture.conic_xy[i]);
    kernels.conic_yy[i] = static_cast<float>(yy);
    kernels.half_width[i] = static_cast<float>(std::sqrt(yy) * per_root);
    kernels.half_height[i] = static_cast<float>(std::sqrt(xx) * per_root);
    const double weight = std::sqrt(axes.lacking[i] * to_weight * per_root);
    noise.weight[i] = static_cast<float>(axes.share[i] < 1 ? weight : 0);
  }
}

}  // namespace

void make_noise_kernels(const NoiseTarget& target, const KernelRow& picture, int count,
                        WeightedKernelRow& noise) {
  Axes axes;
  find_axes(target, picture, count, axes);
  for (int axis = 0; axis < 2; ++axis) {
    alignas(32) Doubles correlation;
    find_correlations(target.correlation, count, axes.share, axes.per_lacking, axes.inverse_variance[axis],
                      correlation);
    change_eigenvalues(count, correlation, axes.inverse_variance[axis], axes.per_inverse_variance[axis],
                       axes.eigenvalue[axis]);
  }
  set_kernels(target, picture, axes, count, noise);
}

}  // namespace cps
