#include "trainer/evaluation/ray_comparison.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <numeric>

#include "numbers/quantile.h"
#include "trainer/evaluation/bootstrap.h"

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

/// Of all these images, whatever their cameras.
RayComparison compare_all_rays(std::span<const RayErrors> network, std::span<const RayErrors> training_mean,
                               std::span<const int> clusters, int resamples, Stream stream) {
  const auto statistics = [&](std::span<const int> chosen) {
    std::vector<RayErrors> errors;
    for (int i : chosen) errors.push_back(network[i]);
    const RaySummary summary = summarise(errors);
    std::vector<double> values;
    for (const RayNumber& number : numbers_of_rays) values.push_back(summary.*number.value);
    return values;
  };
  return {.camera = {},
          .network = summarise(network),
          .training_mean = summarise(training_mean),
          .intervals = bootstrap_intervals(clusters, statistics, resamples, stream),
          .by_camera = {}};
}

/// A mean of a camera's row, and the images that it leaves out.
struct CameraNumber {
  const char* name;
  double RaySummary::*value;
  int RaySummary::*without;
};
constexpr std::array<CameraNumber, 4> camera_numbers{{
    {"seen H-FOV", &RaySummary::seen_hfov_mean_deg, &RaySummary::without_seen_hfov},
    {"rays, deg", &RaySummary::angle_mean_deg, &RaySummary::without_angles},
    {"turned", &RaySummary::turned_mean_deg, &RaySummary::without_angles},
    {"pixels", &RaySummary::reprojection_mean_px, &RaySummary::without_reprojection},
}};

/// A dash where no image has the number, which would read as no error.
std::string camera_cell(const RaySummary& summary, const CameraNumber& number) {
  if (summary.*number.without == summary.images) return fmt::format(" {:>10}", "-");
  return fmt::format(" {:10.4g}", summary.*number.value);
}

std::string camera_rows(const std::vector<RayComparison>& cameras) {
  if (cameras.empty()) return "";
  std::string text = fmt::format("\n{:<24} {:>6}", "mean errors by camera", "images");
  for (const CameraNumber& number : camera_numbers)
    text += fmt::format(" {:>10} {:>10}", number.name, "mean's");
  text += "\n";
  for (const RayComparison& camera : cameras) {
    text += fmt::format("{:<24} {:6}", camera.camera, camera.network.images);
    for (const CameraNumber& number : camera_numbers)
      text += camera_cell(camera.network, number) + camera_cell(camera.training_mean, number);
    text += "\n";
  }
  return text;
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
                           std::span<const int> clusters, std::span<const std::string> cameras, int resamples,
                           std::uint64_t seed) {
  const Stream stream = make_stream(seed, "bootstrap of rays");
  RayComparison all = compare_all_rays(network, training_mean, clusters, resamples, stream);
  std::map<std::string, std::vector<int>> images_of;
  for (int i = 0; i < static_cast<int>(cameras.size()); ++i) images_of[cameras[i]].push_back(i);
  if (images_of.size() < 2) return all;
  for (const auto& [camera, images] : images_of) {
    std::vector<RayErrors> its_network, its_mean;
    std::vector<int> its_clusters;
    for (int i : images) {
      its_network.push_back(network[i]);
      its_mean.push_back(training_mean[i]);
      its_clusters.push_back(clusters[i]);
    }
    all.by_camera.push_back(
        compare_all_rays(its_network, its_mean, its_clusters, resamples, make_stream(stream.key, camera)));
    all.by_camera.back().camera = camera;
  }
  return all;
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
  return text + camera_rows(c.by_camera);
}

nlohmann::ordered_json to_json(const RayComparison& c) {
  nlohmann::ordered_json intervals;
  for (std::size_t k = 0; k < numbers_of_rays.size(); ++k)
    intervals[numbers_of_rays[k].key] = {{"value", c.network.*numbers_of_rays[k].value},
                                         {"low", c.intervals[k].low},
                                         {"high", c.intervals[k].high}};
  nlohmann::ordered_json json{{"intervals_95", intervals},
                              {"network", summary_json(c.network)},
                              {"training_mean", summary_json(c.training_mean)}};
  for (const RayComparison& of_camera : c.by_camera) {
    nlohmann::ordered_json row = to_json(of_camera);
    row["camera"] = of_camera.camera;
    json["by_camera"].push_back(row);
  }
  return json;
}

}  // namespace cps
