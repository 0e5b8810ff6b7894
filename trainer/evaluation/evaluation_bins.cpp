#include "trainer/evaluation/evaluation_bins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>

#include "numbers/angles.h"
#include "trainer/evaluation/bootstrap.h"

namespace cps {
namespace {

enum class BinKind { hfov, size, camera, lens };
constexpr std::array bin_kind_names{"H-FOV", "size", "camera", "lens"};

constexpr int hfov_bin_deg = 10, k1_bins_per_unit = 10;

/// Sorts bins as they are listed.
struct BinKey {
  BinKind kind;
  int number;  ///< of the bin along an axis of values; 0 where names tell bins apart
  std::string name;
  auto operator<=>(const BinKey&) const = default;
};

BinKey hfov_bin(const CalibratedCamera& truth) {
  const int number = static_cast<int>(std::floor(degrees(hfov_rad(truth.pinhole)) / hfov_bin_deg));
  return {BinKind::hfov, number,
          fmt::format("{:3} to {:3} deg", number * hfov_bin_deg, (number + 1) * hfov_bin_deg)};
}

Interval k1_range(int number) {
  return {number / double(k1_bins_per_unit), (number + 1) / double(k1_bins_per_unit)};
}

BinKey lens_bin(const CalibratedCamera& truth) {
  const double k1 = to_outputs(truth, TargetSpace::apparent)[1];
  const int number = static_cast<int>(std::floor(k1 * k1_bins_per_unit));
  const Interval range = k1_range(number);
  return {BinKind::lens, number, fmt::format("K1 {:.1f} to {:.1f}", range.low, range.high)};
}

std::optional<Interval> range_of(const BinKey& key) {
  if (key.kind == BinKind::hfov)
    return Interval{double(key.number * hfov_bin_deg), double((key.number + 1) * hfov_bin_deg)};
  if (key.kind == BinKind::lens) return k1_range(key.number);
  return std::nullopt;
}

/// Of the chosen images' mean errors: H-FOV in degrees, then reprojection in pixels.
std::vector<Interval> mean_intervals(std::span<const EvaluatedImage> images, std::span<const int> chosen,
                                     int resamples, std::uint64_t seed) {
  std::vector<int> clusters;
  for (int i : chosen) clusters.push_back(images[i].image.cluster);
  const auto means = [&](std::span<const int> drawn) {
    double hfov_deg = 0, reprojection_px = 0;
    int cameras = 0;
    for (int k : drawn) {
      const ImageErrors& errors = images[chosen[k]].network;
      hfov_deg += errors.hfov_deg;
      reprojection_px += errors.reprojection_px.value_or(0);
      cameras += errors.reprojection_px.has_value();
    }
    return std::vector{hfov_deg / static_cast<double>(drawn.size()), reprojection_px / std::max(1, cameras)};
  };
  return bootstrap_intervals(clusters, means, resamples, make_stream(seed, "bins"));
}

}  // namespace

std::vector<EvaluationBin> bins_of(std::span<const EvaluatedImage> images, int resamples,
                                   std::uint64_t seed) {
  std::map<BinKey, std::vector<int>> members;
  for (int i = 0; i < static_cast<int>(images.size()); ++i) {
    const EvaluationImage& image = images[i].image;
    const Pinhole& camera = image.truth.pinhole;
    members[hfov_bin(image.truth)].push_back(i);
    members[{BinKind::size, 0, fmt::format("{}x{}", camera.width, camera.height)}].push_back(i);
    members[{BinKind::camera, 0, image.camera}].push_back(i);
    members[lens_bin(image.truth)].push_back(i);
  }
  std::vector<EvaluationBin> bins;
  for (const auto& [key, chosen] : members) {
    const std::vector<Interval> intervals = mean_intervals(images, chosen, resamples, seed);
    bins.push_back({.kind = bin_kind_names[static_cast<std::size_t>(key.kind)],
                    .name = key.name,
                    .range = range_of(key),
                    .images = static_cast<int>(chosen.size()),
                    .network = summary_of(images, chosen, &EvaluatedImage::network),
                    .training_mean = summary_of(images, chosen, &EvaluatedImage::training_mean),
                    .hfov_interval_deg = intervals[0],
                    .reprojection_interval_px = intervals[1]});
  }
  return bins;
}

}  // namespace cps
