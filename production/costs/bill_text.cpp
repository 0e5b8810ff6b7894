#include <fmt/format.h>

#include <cmath>

#include "production/costs/bill.h"

namespace cps {
namespace {

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

std::string start_text(std::int64_t shards) {
  if (shards == 1) return "scenes loaded, lenses and places drawn";
  return fmt::format(
      "{} shards load scenes and draw places for their own views, lenses for all; finish again", shards);
}

/// Nothing where light is traced.
std::string cells_text(double core_h) {
  if (core_h == 0) return "";
  return fmt::format(
      "  cells      {:>10.3g} core-hours at most: views share those of the places that they have in common\n",
      core_h);
}

double dataset_bytes(const Bill& bill) {
  return bill.image_bytes + bill.scene_bytes;
}

/// Table of rates: a row for each size, a column for each H-FOV.
std::string rates_text(const Recipe& recipe, const std::vector<double>& set_images_per_core_h) {
  const bool is_base = recipe.hfov_deg.empty();
  const std::vector<double>& hfovs = is_base ? recipe.base_hfov_deg : recipe.hfov_deg;
  std::string text =
      fmt::format("Images a core-hour, rendered and made, by {}H-FOV:\n           ", is_base ? "base " : "");
  for (double hfov : hfovs) text += fmt::format("{:>6.4g}°", hfov);
  for (std::size_t set = 0; set < set_images_per_core_h.size(); ++set) {
    const auto& size = recipe.sizes[set / hfovs.size()];
    if (set % hfovs.size() == 0)
      text += fmt::format("\n  {:<9}", fmt::format("{}x{}", size.width, size.height));
    text += fmt::format("{:>7.0f}", set_images_per_core_h[set]);
  }
  return text + "\n";
}

}  // namespace

std::string to_text(const Recipe& recipe, const Bill& bill, const Pilot& pilot, const Resources& resources) {
  const RecipeCounts& n = bill.counts;
  const double images = static_cast<double>(n.images);
  std::string text = fmt::format(
      "{}: {} images in {} folders, of {} views in {} conditions of {} scenes\n"
      "  render     {:>10.3g} core-hours\n"
      "{}"
      "  images     {:>10.3g} core-hours: warp, sensor, encoding\n"
      "  scenes     {:>10.3g} core-hours: made\n"
      "  start-up   {:>10.3g} core-hours: {}\n"
      "  all        {:>10.3g} core-hours, standard error {:.2g}; {:.3g} images a core-hour\n",
      recipe.name, n.images, n.groups, n.views, n.conditions, n.scenes, bill.render_core_h,
      cells_text(bill.cells_core_h), bill.images_core_h, bill.scenes_core_h, bill.start_core_h,
      start_text(bill.processes.shards), bill.core_h, bill.core_h_error, images / bill.core_h);
  text += fmt::format("  time       {:>10} on {} cores that do nothing else\n",
                      hours_text(bill.core_h / resources.cores), resources.cores);
  if (resources.price_per_core_h > 0)
    text += fmt::format("  cost       {:>10.2f} at {} a core-hour\n",
                        bill.core_h * resources.price_per_core_h, resources.price_per_core_h);
  text += fmt::format(
      "  memory     {:>10} in one process{}\n", bytes_text(static_cast<double>(bill.peak_bytes)),
      bill.scenes_held > 1 ? ", which loads the next condition's scene while it renders one" : "");
  text += fmt::format("  disk       {:>10}: {} an image, {} of scenes; {} has {} free{}\n",
                      bytes_text(dataset_bytes(bill)), bytes_text(bill.image_bytes / images),
                      bytes_text(bill.scene_bytes), resources.folder, bytes_text(resources.free_bytes),
                      dataset_bytes(bill) > resources.free_bytes ? ": NOT ENOUGH" : "");
  text += rates_text(recipe, bill.set_images_per_core_h);
  text += fmt::format(
      "Measured: {} views in {} conditions at reduced size; {} at full size with {} images, whose renders "
      "took "
      "{:.2f} of the time estimated from the reduced ones. Render times of one size and H-FOV vary by {:.0f} "
      "%.\n",
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
          {"cells_core_h", bill.cells_core_h},
          {"images_core_h", bill.images_core_h},
          {"scenes_core_h", bill.scenes_core_h},
          {"start_core_h", bill.start_core_h},
          {"core_h", bill.core_h},
          {"core_h_standard_error", bill.core_h_error},
          {"images_per_core_h", static_cast<double>(n.images) / bill.core_h},
          {"set_images_per_core_h", bill.set_images_per_core_h},
          {"shards", bill.processes.shards},
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
