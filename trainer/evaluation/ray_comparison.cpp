#include "trainer/evaluation/ray_comparison.h"

#include <fmt/format.h>

#include <array>
#include <numeric>

#include "trainer/evaluation/bootstrap.h"
#include "trainer/evaluation/lens_errors.h"

namespace cps {
namespace {

constexpr std::array<RayNumber, 9> numbers_of_rays{{
    {"angle_mean_deg", "angle of rays, mean", "deg", &RaySummary::angle_mean_deg},
    {"angle_median_deg", "angle of rays, median", "deg", &RaySummary::angle_median_deg},
    {"angle_p95_deg", "angle of rays, 95 % of pixels", "deg", &RaySummary::angle_p95_deg},
    {"turned_mean_deg", "after the best turn, mean", "deg", &RaySummary::turned_mean_deg},
    {"turned_median_deg", "after the best turn, median", "deg", &RaySummary::turned_median_deg},
    {"reprojection_mean_px", "reprojection, mean", "px", &RaySummary::reprojection_mean_px},
    {"reprojection_median_px", "reprojection, median", "px", &RaySummary::reprojection_median_px},
    {"seen_hfov_mean_deg", "seen H-FOV error, mean", "deg", &RaySummary::seen_hfov_mean_deg},
    {"seen_hfov_median_deg", "seen H-FOV error, median", "deg", &RaySummary::seen_hfov_median_deg},
}};

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

nlohmann::ordered_json summary_json(const RaySummary& summary) {
  nlohmann::ordered_json json{{"images", summary.images}};
  for (const RayNumber& number : numbers_of_rays) json[number.key] = summary.*number.value;
  json["without_angles"] = summary.without_angles;
  json["without_reprojection"] = summary.without_reprojection;
  json["without_seen_hfov"] = summary.without_seen_hfov;
  return json;
}

}  // namespace

std::span<const RayNumber> ray_numbers() {
  return numbers_of_rays;
}

RaySummary summarise(std::span<const RayErrors> errors) {
  RaySummary s;
  s.images = static_cast<int>(errors.size());
  std::vector<double> angles, quantiles, turned, pixels, seen;
  for (const RayErrors& e : errors) {
    if (e.angles) {
      angles.push_back(e.angles->mean_deg);
      quantiles.push_back(e.angles->p95_deg);
      turned.push_back(e.angles->turned_mean_deg);
    }
    if (e.reprojection_px) pixels.push_back(*e.reprojection_px);
    if (e.seen_hfov_deg) seen.push_back(*e.seen_hfov_deg);
  }
  s.angle_mean_deg = mean_of(angles);
  s.angle_median_deg = quantile(angles, .5);
  s.angle_p95_deg = mean_of(quantiles);
  s.turned_mean_deg = mean_of(turned);
  s.turned_median_deg = quantile(turned, .5);
  s.reprojection_mean_px = mean_of(pixels);
  s.reprojection_median_px = quantile(pixels, .5);
  s.seen_hfov_mean_deg = mean_of(seen);
  s.seen_hfov_median_deg = quantile(seen, .5);
  s.without_angles = s.images - static_cast<int>(angles.size());
  s.without_reprojection = s.images - static_cast<int>(pixels.size());
  s.without_seen_hfov = s.images - static_cast<int>(seen.size());
  return s;
}

RayComparison compare_rays(std::span<const RayErrors> network, std::span<const RayErrors> training_mean,
                           std::span<const int> clusters, int resamples, std::uint64_t seed) {
  const auto statistics = [&](std::span<const int> chosen) {
    std::vector<RayErrors> errors;
    for (int i : chosen) errors.push_back(network[i]);
    const RaySummary summary = summarise(errors);
    std::vector<double> values;
    for (const RayNumber& number : numbers_of_rays) values.push_back(summary.*number.value);
    return values;
  };
  return {summarise(network), summarise(training_mean),
          bootstrap_intervals(clusters, statistics, resamples, make_stream(seed, "bootstrap of rays"))};
}

std::string report(const RayComparison& c) {
  std::string text =
      fmt::format("\n{:<35} {:>12} {:>12}  95 % interval\n", "in ray space", "network", "train mean");
  for (std::size_t k = 0; k < numbers_of_rays.size(); ++k) {
    const RayNumber& number = numbers_of_rays[k];
    text += fmt::format("{:<30} {:<4} {:12.4g} {:12.4g}  [{:.4g}, {:.4g}]\n", number.name, number.unit,
                        c.network.*number.value, c.training_mean.*number.value, c.intervals[k].low,
                        c.intervals[k].high);
  }
  const auto count_row = [&](const char* name, int RaySummary::*count) {
    text += fmt::format("{:<35} {:12} {:12}\n", name, c.network.*count, c.training_mean.*count);
  };
  count_row("images without angles", &RaySummary::without_angles);
  count_row("images without reprojection", &RaySummary::without_reprojection);
  count_row("images without seen H-FOV", &RaySummary::without_seen_hfov);
  return text;
}

nlohmann::ordered_json to_json(const RayComparison& c) {
  nlohmann::ordered_json intervals;
  for (std::size_t k = 0; k < numbers_of_rays.size(); ++k)
    intervals[numbers_of_rays[k].key] = {{"value", c.network.*numbers_of_rays[k].value},
                                         {"low", c.intervals[k].low},
                                         {"high", c.intervals[k].high}};
  return {{"intervals_95", intervals},
          {"network", summary_json(c.network)},
          {"training_mean", summary_json(c.training_mean)}};
}

}  // namespace cps
