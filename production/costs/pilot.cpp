#include "production/costs/pilot.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/pieces.h"
#include "numbers/cpu_time.h"
#include "production/condition_scene.h"
#include "production/dense_labels.h"
#include "production/load_scene.h"
#include "production/scene_files.h"
#include "production/view_images.h"
#include "renderer/memory_estimate.h"
#include "sampler/plan/place_views.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

/// Pixels of a reduced render: about a second, enough for a stable timing. Traced images have four times as
/// many paths in a pixel as a master has.
constexpr double small_pixels = 150'000, small_traced_pixels = small_pixels / 4;

double process_cpu_s() {
  return cpu_s(CLOCK_PROCESS_CPUTIME_ID);
}

std::int64_t peak_bytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

/// A temporary folder that is removed with its contents.
struct ScratchFolder {
  fs::path path;
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "cps_plan_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made; set TMPDIR");
    path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// The recipe with all sets but only a few conditions. Conditions are chosen by scene: the recipe's first
/// scenes, because the styles of its cities alternate.
Recipe pilot_recipe(Recipe recipe, int conditions) {
  const auto keep = [&](auto& list, int count) {
    list.resize(std::min(list.size(), static_cast<std::size_t>(std::max(0, count))));
    return static_cast<int>(list.size());
  };
  int left = conditions;
  left -= keep(recipe.scenes, left);
  left -= keep(recipe.city_seeds, left);
  recipe.cities = std::min(recipe.cities, left);
  left -= recipe.cities;
  const int scenes = conditions - left;
  recipe.conditions_per_scene = std::min(recipe.conditions_per_scene, (conditions + scenes - 1) / scenes);
  // One view for each condition, and at least one for each part of the split.
  recipe.views = std::max(3, scenes * recipe.conditions_per_scene);
  return recipe;
}

Pinhole smaller(const Pinhole& camera, int times) {
  Pinhole small = camera;
  small.width = std::max(1, camera.width / times);
  small.height = std::max(1, camera.height / times);
  const double factor = static_cast<double>(small.width) / camera.width;
  small.fx = small.fy = camera.fx * factor;
  small.cx = 0.5 * (small.width - 1);
  small.cy = 0.5 * (small.height - 1);
  return small;
}

/// What is rendered of a view, so many times smaller on each axis.
ViewImages smaller(ViewImages wanted, int times) {
  if (!wanted.are_traced()) wanted.master = smaller(wanted.master, times);
  for (PlannedImage& image : wanted.images)
    if (image.model)
      image.model = resized(*image.model, std::max(1, image.model->pinhole.width / times),
                            std::max(1, image.model->pinhole.height / times));
  return wanted;
}

std::int64_t bytes_of(const RenderedView& rendered) {
  std::int64_t bytes = 0;
  for (const OIIO::ImageBuf& image : rendered.traced)
    bytes += static_cast<std::int64_t>(image.spec().image_bytes());
  if (!rendered.traced.empty()) return bytes;
  return static_cast<std::int64_t>(rendered.first.spec().image_bytes() +
                                   rendered.second.spec().image_bytes());
}

/// Measurements of full-size views of one image size.
struct FullSize {
  int wanted = 1, views = 0, images = 0;
  double cpu_s = 0, bytes = 0;
};

/// Makes the pilot's plan and times what generate does before the first render.
Plan timed_plan(const Recipe& recipe, const Rig& rig, const DriveOptions& drive, const fs::path& folder,
                const Watch& watch, Pilot& pilot) {
  std::vector<PlannedScene> scenes = plan_scenes(recipe, folder);
  const auto scene_count = static_cast<double>(scenes.size());
  double before = process_cpu_s();
  make_scene_files(scenes, folder);
  pilot.city_cpu_s = (process_cpu_s() - before) / scene_count;
  for (const PlannedScene& scene : scenes)
    if (scene.city) pilot.scene_bytes += static_cast<double>(fs::file_size(scene.file)) / scene_count;
  before = process_cpu_s();
  Plan plan = outline_plan(recipe, rig, std::move(scenes));
  pilot.start.group_cpu_s = (process_cpu_s() - before) / static_cast<double>(plan.groups.size());
  before = process_cpu_s();
  double load_s = 0, rays_s = 0;
  place_views(plan, all_views(plan), [&](const fs::path& file) {
    const double begin = process_cpu_s();
    sha256_of_file(file);  // as prepare_scenes() does
    DrivenScene driven = load_scene(file, drive, watch);
    const double loaded = process_cpu_s();
    const SceneRays rays(driven.scene);  // built again by place_views(), and not a cost of its draws
    load_s += loaded - begin;
    rays_s += process_cpu_s() - loaded;
    const auto bytes = static_cast<std::int64_t>(estimated_bytes(driven.scene));
    pilot.scene_memory_bytes = std::max(pilot.scene_memory_bytes, bytes);
    return driven;
  });
  const double draws_s = std::max(0.0, process_cpu_s() - before - load_s - 2 * rays_s);
  pilot.start.scene_load_cpu_s = (load_s + rays_s) / scene_count;
  pilot.start.view_place_cpu_s = draws_s / static_cast<double>(plan.views.size());
  return plan;
}

}  // namespace

Pilot run_pilot(const Recipe& recipe, const Rig& rig, const DriveOptions& drive, int conditions,
                const Watch& watch) {
  const ScratchFolder scratch;
  Pilot pilot;
  const Plan plan = timed_plan(pilot_recipe(recipe, conditions), rig, drive, scratch.path, watch, pilot);
  const std::size_t sizes = recipe.sizes.size(), hfovs = plan.sets.size() / sizes;
  std::vector<FullSize> full(sizes, FullSize{.wanted = sizes == 1 ? 3 : 2});
  std::vector<std::vector<double>> sum(plan.conditions.size(), std::vector<double>(plan.sets.size(), 0));
  std::vector<std::vector<int>> count(plan.conditions.size(), std::vector<int>(plan.sets.size(), 0));
  double estimated_s = 0, full_s = 0, cells_s = 0;
  ConditionScene loaded;
  for (std::int64_t v = 0; v < static_cast<std::int64_t>(plan.views.size()); ++v) {
    const PlannedView& view = plan.views[v];
    double before = process_cpu_s();
    LitScene& scene = loaded.of(plan, view);
    pilot.start.condition_cpu_s += (process_cpu_s() - before) / static_cast<double>(plan.conditions.size());
    const ViewImages wanted = images_of(plan, v);
    const double enough_pixels = wanted.are_traced() ? small_traced_pixels : small_pixels;
    const int times = std::max(1, static_cast<int>(std::sqrt(rendered_pixels(wanted) / enough_pixels)));
    const ViewImages small = smaller(wanted, times);
    const RenderedView reduced = render_view(plan.recipe, view, small, scene);
    const double view_s =
        (reduced.cpu_s - reduced.cells_cpu_s) * rendered_pixels(wanted) / rendered_pixels(small);
    sum[view.condition][view.set] += view_s;
    ++count[view.condition][view.set];
    ++pilot.views;

    // At full size: of each image size one view of its middle H-FOV in each of the first conditions.
    FullSize& of_size = full[plan.sets[view.set].size];
    if (view.set % hfovs != hfovs / 2 || view.rig_camera != 0 || of_size.views == of_size.wanted) continue;
    const RenderedView whole = times == 1 ? reduced : render_view(plan.recipe, view, wanted, scene);
    pilot.view_bytes = std::max(pilot.view_bytes, bytes_of(whole));
    full_s += whole.cpu_s - whole.cells_cpu_s;
    // The reduced render has computed some of the view's cells already.
    cells_s += whole.cells_cpu_s + (times == 1 ? 0 : reduced.cells_cpu_s);
    estimated_s += view_s;
    before = process_cpu_s();
    ImageTimes unused;
    std::atomic<std::int64_t> unused_labels_ns = 0;
    const ViewRecord made = make_images(wanted, whole, scratch.path, unused).record;
    const auto dense = make_dense_labels(plan.recipe, view, wanted, scene, scratch.path, unused_labels_ns);
    of_size.cpu_s += process_cpu_s() - before;
    for (const auto& of_image : dense)
      for (const DenseRecord& label : of_image) of_size.bytes += static_cast<double>(label.bytes);
    for (const ImageRecord& image : made.images) of_size.bytes += static_cast<double>(image.bytes);
    if (made.master) of_size.bytes += static_cast<double>(made.master->bytes);
    of_size.images += static_cast<int>(made.images.size());
    ++of_size.views;
  }
  for (std::size_t c = 0; c < sum.size(); ++c) {
    // With fewer conditions than parts of the split, several views of a set share a condition.
    for (std::size_t s = 0; s < sum[c].size(); ++s) sum[c][s] /= std::max(1, count[c][s]);
    pilot.render_cpu_s.push_back(sum[c]);
  }
  pilot.full_size_ratio = full_s / estimated_s;
  for (const FullSize& of_size : full) {
    pilot.image_costs.push_back({of_size.cpu_s / of_size.images, of_size.bytes / of_size.images});
    pilot.full_size_views += of_size.views;
    pilot.images += of_size.images;
  }
  pilot.cells_cpu_s = cells_s / pilot.full_size_views;
  pilot.peak_bytes = peak_bytes();
  return pilot;
}

}  // namespace cps
