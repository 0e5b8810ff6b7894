#include "apps/plan/bill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

std::string bytes_text(double bytes) {
  constexpr const char* units[] = {"B", "kB", "MB", "GB", "TB", "PB"};
  int unit = 0;
  for (; bytes >= 1000 && unit < 5; ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

std::string hours_text(double hours) {
  if (hours < 1) return fmt::format("{:.0f} min", std::ceil(60 * hours));
  return hours < 72 ? fmt::format("{:.1f} h", hours) : fmt::format("{:.1f} days", hours / 24);
}

double dataset_bytes(const Bill& bill) {
  return bill.image_bytes + bill.scene_bytes;
}

}  // namespace

Bill bill_of(const Recipe& recipe, const RecipeCounts& counts, const Pilot& pilot) {
  constexpr double hour_s = 3600;
  const auto sets = static_cast<std::size_t>(counts.sets), hfovs = sets / recipe.sizes.size();
  const double cameras = static_cast<double>(counts.views) / [&] {
    double places = 0;
    for (std::size_t set = 0; set < sets; ++set) places += recipe.views[set / hfovs];
    return places;
  }();
  Bill bill{.counts = counts, .peak_bytes = pilot.peak_bytes};

  // Each measured condition foretells the whole; their mean is the estimate, and they tell how sure it is.
  std::vector<double> foretold_h;
  for (const std::vector<double>& of_condition : pilot.render_cpu_s) {
    double seconds = 0;
    for (std::size_t set = 0; set < sets; ++set)
      seconds += of_condition[set] * cameras * recipe.views[set / hfovs];
    foretold_h.push_back(seconds * pilot.full_size_ratio / hour_s);
  }
  bill.render_core_h = mean(foretold_h);
  bill.core_h_error = deviation(foretold_h) / std::sqrt(static_cast<double>(foretold_h.size()));
  double squared_error_h = 0;  // as if every view had a condition of its own
  for (std::size_t set = 0; set < sets; ++set) {
    std::vector<double> seconds;
    for (const std::vector<double>& of_condition : pilot.render_cpu_s) seconds.push_back(of_condition[set]);
    bill.view_cpu_s_spread += deviation(seconds) / mean(seconds) / static_cast<double>(sets);
    squared_error_h +=
        std::pow(cameras * recipe.views[set / hfovs] * deviation(seconds) * pilot.full_size_ratio / hour_s,
                 2) /
        static_cast<double>(seconds.size());
    const double images =
        cameras * recipe.views[set / hfovs] * (recipe.lenses[set / hfovs] + (recipe.undistorted ? 1 : 0));
    bill.images_core_h += images * pilot.image_costs[set / hfovs].cpu_s / hour_s;
    bill.image_bytes += images * pilot.image_costs[set / hfovs].bytes;
  }
  bill.core_h_error = std::max(bill.core_h_error, std::sqrt(squared_error_h));
  const auto conditions = static_cast<double>(counts.conditions);
  bill.scenes_core_h = conditions * (pilot.scene_cpu_s + pilot.condition_cpu_s) / hour_s;
  bill.scene_bytes = conditions * pilot.scene_bytes;
  bill.plan_core_h = static_cast<double>(counts.views) * pilot.view_plan_cpu_s / hour_s;
  bill.core_h = bill.render_core_h + bill.images_core_h + bill.scenes_core_h + bill.plan_core_h;
  return bill;
}

std::string to_text(const Recipe& recipe, const Bill& bill, const Pilot& pilot, const Resources& resources) {
  const RecipeCounts& n = bill.counts;
  const double images = static_cast<double>(n.images);
  std::string text = fmt::format(
      "{}: {} images in {} folders, of {} views in {} conditions of {} scenes\n"
      "  render     {:>10.3g} core-hours\n"
      "  images     {:>10.3g} core-hours: warp, sensor, encoding\n"
      "  scenes     {:>10.3g} core-hours: making, loading\n"
      "  places     {:>10.3g} core-hours, in every shard again\n"
      "  all        {:>10.3g} core-hours, standard error {:.2g}; {:.3g} images a core-hour\n",
      recipe.name, n.images, n.groups, n.views, n.conditions, n.scenes, bill.render_core_h,
      bill.images_core_h, bill.scenes_core_h, bill.plan_core_h, bill.core_h, bill.core_h_error,
      images / bill.core_h);
  text += fmt::format("  time       {:>10} on {} cores that do nothing else\n",
                      hours_text(bill.core_h / resources.cores), resources.cores);
  if (resources.price_per_core_h > 0)
    text += fmt::format("  cost       {:>10.2f} at {} a core-hour\n",
                        bill.core_h * resources.price_per_core_h, resources.price_per_core_h);
  text +=
      fmt::format("  memory     {:>10} in one process\n", bytes_text(static_cast<double>(bill.peak_bytes)));
  text += fmt::format("  disk       {:>10}: {} an image, {} of scenes; {} has {} free{}\n",
                      bytes_text(dataset_bytes(bill)), bytes_text(bill.image_bytes / images),
                      bytes_text(bill.scene_bytes), resources.folder, bytes_text(resources.free_bytes),
                      dataset_bytes(bill) > resources.free_bytes ? ": NOT ENOUGH" : "");
  text += fmt::format(
      "Measured: {} views in {} conditions, small; {} at full size with {} images, which took {:.2f} of what "
      "the small ones foretell. Renders of one size and H-FOV differ by {:.0f} %.\n",
      pilot.views, pilot.render_cpu_s.size(), pilot.full_size_views, pilot.images, pilot.full_size_ratio,
      100 * bill.view_cpu_s_spread);
  return text;
}

nlohmann::ordered_json to_json(const Recipe& recipe, const Bill& bill, const Pilot& pilot,
                               const Resources& resources) {
  const RecipeCounts& n = bill.counts;
  return {{"recipe", recipe.name},
          {"scenes", n.scenes},
          {"conditions", n.conditions},
          {"sets", n.sets},
          {"groups", n.groups},
          {"views", n.views},
          {"images", n.images},
          {"render_core_h", bill.render_core_h},
          {"images_core_h", bill.images_core_h},
          {"scenes_core_h", bill.scenes_core_h},
          {"plan_core_h", bill.plan_core_h},
          {"core_h", bill.core_h},
          {"core_h_standard_error", bill.core_h_error},
          {"images_per_core_h", static_cast<double>(n.images) / bill.core_h},
          {"cores", resources.cores},
          {"wall_h", bill.core_h / resources.cores},
          {"price_per_core_h", resources.price_per_core_h},
          {"cost", bill.core_h * resources.price_per_core_h},
          {"memory_bytes", bill.peak_bytes},
          {"image_bytes", bill.image_bytes},
          {"scene_bytes", bill.scene_bytes},
          {"free_bytes", resources.free_bytes},
          {"fits_disk", dataset_bytes(bill) <= resources.free_bytes},
          {"measured",
           {{"views", pilot.views},
            {"full_size_views", pilot.full_size_views},
            {"images", pilot.images},
            {"full_size_ratio", pilot.full_size_ratio},
            {"render_spread", bill.view_cpu_s_spread},
            {"render_cpu_s_by_condition_and_set", pilot.render_cpu_s}}}};
}

}  // namespace cps
