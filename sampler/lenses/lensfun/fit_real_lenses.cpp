#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "sampler/lenses/lensfun/profiles.h"
#include "sampler/lenses/real_lens_prior.h"

/// Fits the numbers of sampler/lenses/real_lens_numbers.h to the Lensfun database and prints that file:
/// fit_real_lenses /usr/share/lensfun/version_1 > sampler/lenses/real_lens_numbers.h
namespace {

using namespace cps;

/// Linear between the order statistics.
double quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double rank = p * (static_cast<double>(values.size()) - 1);
  const auto below = static_cast<std::size_t>(rank);
  return std::lerp(values[below], values[std::min(below + 1, values.size() - 1)], rank - std::floor(rank));
}

/// Half the distance between the quantiles that lie one standard deviation from a normal's mean: a standard
/// deviation that outliers do not move.
double robust_sd(const std::vector<double>& values) {
  return 0.5 * (quantile(values, 0.8413) - quantile(values, 0.1587));
}

/// Slope of the least-squares line through the origin.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto map = [](const std::vector<double>& v) { return Eigen::VectorXd::Map(v.data(), v.size()); };
  return map(x).dot(map(y)) / map(x).squaredNorm();
}

std::vector<double> residuals(const std::vector<double>& x, const std::vector<double>& y, double slope) {
  std::vector<double> rest(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) rest[i] = y[i] - slope * x[i];
  return rest;
}

RealLensFit fit(double hfov_deg, const std::vector<Distortion>& lenses) {
  std::vector<double> corner, k2, k3;
  for (const Distortion& lens : lenses) {
    corner.push_back(lens.k1 + lens.k2 + lens.k3);
    k2.push_back(lens.k2);
    k3.push_back(lens.k3);
  }
  RealLensFit fit{};
  fit.hfov_deg = hfov_deg;
  for (std::size_t i = 0; i < fit.corner.size(); ++i)
    fit.corner[i] = quantile(corner, std::clamp(corner_probabilities[i], 0.01, 0.99));
  fit.k2_slope = slope(corner, k2);
  const std::vector<double> k2_rest = residuals(corner, k2, fit.k2_slope);
  fit.k2_sd = robust_sd(k2_rest);
  fit.k3_slope = slope(corner, k3);
  const std::vector<double> k3_rest = residuals(corner, k3, fit.k3_slope);
  fit.k3_on_k2 = slope(k2_rest, k3_rest);
  fit.k3_sd = robust_sd(residuals(k2_rest, k3_rest, fit.k3_on_k2));
  return fit;
}

void print(const RealLensFit& fit) {
  std::cout << fmt::format(
      "    {{.hfov_deg = {}, .corner = {{{:.4f}}}, .k2_slope = {:.3f}, .k2_sd = {:.4f}, "
      ".k3_slope = {:.3f}, .k3_on_k2 = {:.3f}, .k3_sd = {:.4f}}},\n",
      fit.hfov_deg, fmt::join(fit.corner, ", "), fit.k2_slope, fit.k2_sd, fit.k3_slope, fit.k3_on_k2,
      fit.k3_sd);
}

void fit_all(const std::filesystem::path& folder) {
  constexpr int bins = 10;  // within 5° of 10°, 20°, … 100°; the last one takes what is wider
  std::vector<Distortion> lenses[bins];
  std::vector<double> worst;
  int refused = 0;
  for (const LensfunProfile& profile : read_lensfun(folder)) {
    const auto lens = converted(profile);
    if (!lens) {
      ++refused;
      continue;
    }
    worst.push_back(lens->largest_residual);
    lenses[std::clamp(static_cast<int>(std::lround(profile.hfov_deg / 10)), 1, bins) - 1].push_back(
        lens->lens);
  }
  std::cerr << worst.size() << " profiles, " << refused << " refused, median of the largest residuals "
            << quantile(worst, 0.5) << " of the half diagonal\n";
  std::cout << "#pragma once\n\n#include \"sampler/lenses/real_lens_prior.h\"\n\nnamespace cps {\n\n"
               "/// Printed by fit_real_lenses from the Lensfun database (CC BY-SA 3.0); not to be edited.\n"
               "// clang-format off\n"
               "inline constexpr RealLensFit real_lens_numbers[] = {\n";
  for (int bin = 0; bin < bins; ++bin) print(fit(10 * (bin + 1), lenses[bin]));
  std::cout << "};\n// clang-format on\n\n}  // namespace cps\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr
        << "fit_real_lenses FOLDER: prints sampler/lenses/real_lens_numbers.h; FOLDER is Lensfun's database, "
           "/usr/share/lensfun/version_1 in Debian's liblensfun-data-v1\n";
    return 2;
  }
  fit_all(argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "fit_real_lenses: " << error.what() << "\n";
  return 1;
}
