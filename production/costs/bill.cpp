#include "production/costs/bill.h"

#include <algorithm>
#include <cmath>

#include "production/make_views.h"

namespace cps {
namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  double squares = 0;
  for (double value : values) squares += std::pow(value - mean(values), 2);
  return values.size() < 2 ? 0 : std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// CPU seconds of all processes before they render. A shard plans every group, but loads the scenes of its
/// own views alone, each for its places and to render it; two neighbours have at most one in common. After
/// several shards cps finish plans everything once more.
double start_cpu_s(const RecipeCounts& counts, const StartCosts& costs, std::int64_t shards) {
  const double again = shards > 1 ? 1 : 0;
  const auto shared = static_cast<double>(std::min(shards, std::max<std::int64_t>(counts.views, 1)) - 1);
  const auto files = static_cast<double>(counts.scene_files);
  return (static_cast<double>(shards) + again) * static_cast<double>(counts.groups) * costs.group_cpu_s +
         (files + shared + again * files) * costs.scene_load_cpu_s +
         (1 + again) * static_cast<double>(counts.views) * costs.view_place_cpu_s +
         (static_cast<double>(counts.conditions) + shared) * costs.condition_cpu_s;
}

}  // namespace

Bill bill_of(const Recipe& recipe, const RecipeCounts& counts, const Pilot& pilot,
             const Processes& processes) {
  constexpr double hour_s = 3600;
  const auto sets = static_cast<std::size_t>(counts.sets), hfovs = sets / recipe.sizes.size();
  double places = 0;
  for (std::size_t set = 0; set < sets; ++set) places += recipe.views[set / hfovs];
  const auto views_of_set = [&](std::size_t set) {
    return recipe.views[set / hfovs] * static_cast<double>(counts.views) / places;
  };
  Bill bill{.counts = counts, .processes = processes};
  bill.scenes_held = counts.conditions > 1 ? scenes_in_memory(processes.threads) : 1;
  bill.peak_bytes = pilot.peak_bytes + (views_in_flight(processes.threads) - 1) * pilot.view_bytes +
                    (bill.scenes_held - 1) * pilot.scene_memory_bytes;

  // Each measured condition gives an estimate of the whole; their spread gives the mean's standard error.
  std::vector<double> estimated_h;
  for (const std::vector<double>& of_condition : pilot.render_cpu_s) {
    double seconds = 0;
    for (std::size_t set = 0; set < sets; ++set) seconds += of_condition[set] * views_of_set(set);
    estimated_h.push_back(seconds * pilot.full_size_ratio / hour_s);
  }
  bill.render_core_h = mean(estimated_h);
  bill.core_h_error = deviation(estimated_h) / std::sqrt(static_cast<double>(estimated_h.size()));
  double squared_error_h = 0;  // as if every view had its own condition
  for (std::size_t set = 0; set < sets; ++set) {
    std::vector<double> view_s;
    for (const std::vector<double>& of_condition : pilot.render_cpu_s)
      view_s.push_back(of_condition[set] * pilot.full_size_ratio);
    bill.view_cpu_s_spread += deviation(view_s) / mean(view_s) / static_cast<double>(sets);
    squared_error_h +=
        std::pow(views_of_set(set) * deviation(view_s) / hour_s, 2) / static_cast<double>(view_s.size());
    const ImageCost& image = pilot.image_costs[set / hfovs];
    const double images_of_view = recipe.lenses[set / hfovs] + (recipe.undistorted ? 1 : 0);
    const double images = views_of_set(set) * images_of_view;
    bill.images_core_h += images * image.cpu_s / hour_s;
    bill.image_bytes += images * image.bytes;
    bill.set_images_per_core_h.push_back(hour_s / (mean(view_s) / images_of_view + image.cpu_s));
  }
  bill.core_h_error = std::max(bill.core_h_error, std::sqrt(squared_error_h));
  bill.scenes_core_h = static_cast<double>(counts.scene_files) * pilot.city_cpu_s / hour_s;
  bill.scene_bytes = static_cast<double>(counts.scene_files) * pilot.scene_bytes;
  bill.start_core_h = start_cpu_s(counts, pilot.start, processes.shards) / hour_s;
  bill.cells_core_h = static_cast<double>(counts.views) * pilot.cells_cpu_s / hour_s;
  bill.core_h =
      bill.render_core_h + bill.cells_core_h + bill.images_core_h + bill.scenes_core_h + bill.start_core_h;
  return bill;
}

}  // namespace cps
