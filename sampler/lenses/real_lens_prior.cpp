#include "sampler/lenses/real_lens_prior.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "distortion/pinhole.h"
#include "numbers/angles.h"
#include "sampler/lenses/real_lens_numbers.h"

namespace cps {
namespace {

enum QuantileNumber : std::uint64_t { corner_quantile, k2_rest, k3_rest };

double inverse_cdf(const std::array<double, 7>& quantiles, double p) {
  std::size_t i = 1;
  while (i + 1 < quantiles.size() && corner_probabilities[i] < p) ++i;
  const double t =
      (p - corner_probabilities[i - 1]) / (corner_probabilities[i] - corner_probabilities[i - 1]);
  return std::lerp(quantiles[i - 1], quantiles[i], t);
}

}  // namespace

std::span<const RealLensFit> real_lens_fits() {
  return real_lens_numbers;
}

RealLensFit real_lens_fit_at(double hfov_deg) {
  const std::span<const RealLensFit> fits = real_lens_fits();
  const auto above = std::upper_bound(fits.begin(), fits.end(), hfov_deg,
                                      [](double h, const RealLensFit& fit) { return h < fit.hfov_deg; });
  if (above == fits.begin()) return fits.front();
  if (above == fits.end()) return fits.back();
  const RealLensFit& a = *std::prev(above);
  const RealLensFit& b = *above;
  const double t = (hfov_deg - a.hfov_deg) / (b.hfov_deg - a.hfov_deg);
  RealLensFit fit{.hfov_deg = hfov_deg,
                  .corner = {},
                  .k2_slope = std::lerp(a.k2_slope, b.k2_slope, t),
                  .k2_sd = std::lerp(a.k2_sd, b.k2_sd, t),
                  .k3_slope = std::lerp(a.k3_slope, b.k3_slope, t),
                  .k3_on_k2 = std::lerp(a.k3_on_k2, b.k3_on_k2, t),
                  .k3_sd = std::lerp(a.k3_sd, b.k3_sd, t)};
  for (std::size_t i = 0; i < fit.corner.size(); ++i) fit.corner[i] = std::lerp(a.corner[i], b.corner[i], t);
  return fit;
}

Distortion draw_real_lens(double hfov_rad, Stream stream) {
  const RealLensFit fit = real_lens_fit_at(degrees(hfov_rad));
  const double corner = inverse_cdf(fit.corner, random_uniform(stream, corner_quantile));
  const double rest = fit.k2_sd * random_normal(stream, k2_rest);
  const double k2 = fit.k2_slope * corner + rest;
  const double k3 = fit.k3_slope * corner + fit.k3_on_k2 * rest + fit.k3_sd * random_normal(stream, k3_rest);
  return {.k1 = corner - k2 - k3, .k2 = k2, .k3 = k3};
}

}  // namespace cps
