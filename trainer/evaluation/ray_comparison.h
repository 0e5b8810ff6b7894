#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "numbers/interval.h"
#include "trainer/evaluation/ray_errors.h"

namespace cps {

/// Ray errors over a set of images. Images without one are left out of that number.
struct RaySummary {
  int images = 0;
  double angle_mean_deg = 0, angle_median_deg = 0;    ///< over images, of the mean over the pixels
  double angle_p95_deg = 0;                           ///< mean over images of the 95 % quantile over pixels
  double turned_mean_deg = 0, turned_median_deg = 0;  ///< as the first two, of turned_mean_deg
  double reprojection_mean_px = 0, reprojection_median_px = 0;
  double seen_hfov_mean_deg = 0, seen_hfov_median_deg = 0;
  int without_angles = 0, without_reprojection = 0, without_seen_hfov = 0;
};

/// A number of a summary that has an interval.
struct RayNumber {
  const char *key, *name, *unit;  ///< in JSON; on the screen
  double RaySummary::*value;
};
std::span<const RayNumber> ray_numbers();

RaySummary summarise(std::span<const RayErrors> errors);

/// A network beside the training mean, which ignores the image.
struct RayComparison {
  std::string camera;  ///< whose images these are; empty: all
  RaySummary network, training_mean;
  std::vector<Interval> intervals;  ///< 95 %, of the network's ray_numbers()
  /// The images of each camera alone, in the order of their names; empty where all are of one.
  std::vector<RayComparison> by_camera;
};

/// Entry i of the first four arguments belongs to image i; `cameras` are names. Intervals are
/// bootstrap_intervals() over the clusters.
RayComparison compare_rays(std::span<const RayErrors> network, std::span<const RayErrors> training_mean,
                           std::span<const int> clusters, std::span<const std::string> cameras, int resamples,
                           std::uint64_t seed);

/// Aligned lines for the screen.
std::string report(const RayComparison& comparison);

/// With `by_camera` only where there are several cameras.
nlohmann::ordered_json to_json(const RayComparison& comparison);

}  // namespace cps
