#include "trainer/deepcalib/sphere_head.h"

#include <ATen/ATen.h>

#include <numbers>

#include "trainer/deepcalib/bins.h"

namespace cps {
namespace {

using torch::Tensor;

/// [n, 2].
Tensor target_shares(std::span<const SphereTarget> targets) {
  Tensor shares = torch::empty({static_cast<long>(targets.size()), 2}, torch::kDouble);
  double* out = shares.data_ptr<double>();
  for (const SphereTarget& target : targets) {
    *out++ = target.focal;
    *out++ = target.xi;
  }
  return shares;
}

/// [n, 1].
Tensor target_bins(std::span<const SphereTarget> targets, double SphereTarget::*member, int bins) {
  Tensor numbers = torch::empty({static_cast<long>(targets.size()), 1}, torch::kLong);
  std::int64_t* out = numbers.data_ptr<std::int64_t>();
  for (const SphereTarget& target : targets) *out++ = nearest_bin(target.*member, bins);
  return numbers;
}

/// `bins`: [n, 1] on any device.
Tensor cross_entropy(const Tensor& rows, const Tensor& bins) {
  return -at::log_softmax(rows, 1).gather(1, bins.to(rows.device())).mean();
}

/// [n], the mean share under each row's distribution.
Tensor expectation(const Tensor& rows, int bins) {
  std::vector<double> shares;
  for (int bin = 0; bin < bins; ++bin) shares.push_back(bin_share(bin, bins));
  return (at::softmax(rows, 1) * torch::tensor(shares, torch::kDouble)).sum(1);
}

}  // namespace

Tensor log_cosh_loss(const Tensor& a, const Tensor& b) {
  const Tensor off = (a - b).abs();
  return (off + (off * -2).exp().log1p()).mean() - std::numbers::ln2;
}

Tensor sphere_loss(Head head, const Tensor& rows, std::span<const SphereTarget> targets) {
  if (head == Head::deepcalib_regression)
    return log_cosh_loss(rows.sigmoid(), target_shares(targets).to(rows.options()));
  return cross_entropy(rows.narrow(1, 0, focal_bins),
                       target_bins(targets, &SphereTarget::focal, focal_bins)) +
         cross_entropy(rows.narrow(1, focal_bins, xi_bins), target_bins(targets, &SphereTarget::xi, xi_bins));
}

std::vector<SphereTarget> sphere_targets(Head head, const Tensor& rows) {
  const Tensor exact = rows.detach().to(torch::kCPU, torch::kDouble);
  const Tensor shares = (head == Head::deepcalib_regression
                             ? exact.sigmoid()
                             : at::stack({expectation(exact.narrow(1, 0, focal_bins), focal_bins),
                                          expectation(exact.narrow(1, focal_bins, xi_bins), xi_bins)},
                                         1))
                            .contiguous();
  const auto numbers = shares.accessor<double, 2>();
  std::vector<SphereTarget> targets;
  for (std::int64_t i = 0; i < shares.size(0); ++i) targets.push_back({numbers[i][0], numbers[i][1]});
  return targets;
}

}  // namespace cps
