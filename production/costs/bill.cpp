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

}  // namespace

Bill bill_of(const Recipe& recipe, const RecipeCounts& counts, const Pilot& pilot, int threads) {
  constexpr double hour_s = 3600;
  const auto sets = static_cast<std::size_t>(counts.sets), hfovs = sets / recipe.sizes.size();
  double places = 0;
  for (std::size_t set = 0; set < sets; ++set) places += recipe.views[set / hfovs];
  const auto views_of_set = [&](std::size_t set) {
    return recipe.views[set / hfovs] * static_cast<double>(counts.views) / places;
  };
  Bill bill{.counts = counts,
            .peak_bytes = pilot.peak_bytes + (views_in_flight(threads) - 1) * pilot.view_bytes};

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
  const auto conditions = static_cast<double>(counts.conditions);
  bill.scenes_core_h = conditions * (pilot.scene_cpu_s + pilot.condition_cpu_s) / hour_s;
  bill.scene_bytes = conditions * pilot.scene_bytes;
  bill.plan_core_h = static_cast<double>(counts.views) * pilot.view_plan_cpu_s / hour_s;
  bill.core_h = bill.render_core_h + bill.images_core_h + bill.scenes_core_h + bill.plan_core_h;
  return bill;
}

}  // namespace cps
