#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <iostream>

#include "apps/drive_options.h"
#include "apps/options.h"
#include "apps/progress.h"
#include "apps/scene_files.h"
#include "apps/verbs.h"
#include "dataset/files.h"
#include "dataset/finish.h"
#include "dataset/group_label.h"
#include "dataset/journal.h"
#include "dataset/png.h"
#include "distortion/render_noise.h"
#include "renderer/render.h"
#include "sampler/plan.h"
#include "sampler/rig_file.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

/// The undistorted, linear, oversampled render of a view.
NoisyMaster render_master(const Plan& plan, const PlannedView& view, const RenderScene& scene) {
  const Camera camera{.world_from_camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera),
                      .pinhole = view.master};
  const auto render_half = [&](const char* stream) {
    return render(scene, camera,
                  {.samples = plan.recipe.samples / 2,
                   .max_shaded_vertices = plan.recipe.max_shaded_vertices,
                   .seed = make_stream(view.seed, stream).key});
  };
  return join_halves(render_half("first half"), render_half("second half"));
}

/// The master through one lens and the sensor into its file. The sensor is drawn from the view and the
/// group's number alone, so that it knows nothing of the lens.
ImageRecord make_image(const Plan& plan, const PlannedView& view, const PlannedGroup& group,
                       const NoisyMaster& master, double exposure, const fs::path& root) {
  const Stream stream = substream(make_stream(view.seed, "sensor"), group.lens_number);
  const SensorSettings sensor = draw_sensor(plan.recipe.sensor, make_stream(stream.key, "settings"));
  const OIIO::ImageBuf seen = warp(master, view.master, group.lens.distortion, group.lens.crop.camera,
                                   {.box = frame_on_plane(group.lens.base)});
  const OIIO::ImageBuf image = develop(seen, exposure, sensor, make_stream(stream.key, "noise"));
  const std::string png = encode_png(image);
  const std::string file = group.folder + "/" + image_name(view);
  write_file(root / file, png);
  return {.file = file, .sensor = sensor, .sha256 = sha256(png), .pixels_sha256 = pixels_sha256(image)};
}

/// Every image of one view.
ViewRecord make_view(const Plan& plan, std::int64_t index, const RenderScene& scene, const fs::path& root) {
  const PlannedView& view = plan.views[index];
  const NoisyMaster master = render_master(plan, view, scene);
  ViewRecord record{.view = index, .exposure = meter_exposure(master.picture), .images = {}};
  record.images.resize(view.groups.size());
  tbb::parallel_for(std::size_t{0}, view.groups.size(), [&](std::size_t g) {
    record.images[g] = make_image(plan, view, plan.groups[view.groups[g]], master, record.exposure, root);
  });
  return record;
}

void generate(const Plan& plan, Journal& journal, const fs::path& root) {
  for (const PlannedGroup& group : plan.groups)
    write_json(root / group.folder / "calibration.json", to_json(group_label(plan, group)));
  Progress progress("views", static_cast<std::int64_t>(journal.finished().size()),
                    static_cast<std::int64_t>(plan.views.size()));
  std::shared_ptr<RenderScene> scene;
  int loaded = -1;
  for (std::int64_t v = 0; v < static_cast<std::int64_t>(plan.views.size()); ++v) {
    if (journal.finished().contains(v)) continue;
    const PlannedView& view = plan.views[v];
    const PlannedCondition& condition = plan.conditions[view.condition];
    const PlannedScene& planned = plan.scenes[condition.scene];
    if (loaded != view.condition) {
      scene = build_render_scene(load_scene(planned, plan.recipe), condition.light.daylight);
      loaded = view.condition;
    }
    put_car(*scene, world_from_vehicle(view.place));
    journal.append(make_view(plan, v, *scene, root));
    progress.advance(1, planned.file.filename().string() + " " + plan.sets[view.set].folder);
  }
  progress.finish();
}

constexpr const char* usage =
    "cps generate --recipe FILE --out DIR [--KEY VALUE …]\n"
    "Makes a dataset: plans every view and lens, renders each view once, and sends it through its lenses and "
    "the sensor.\n"
    "Run it again after an interruption and it finishes the job; a finished job is left alone.\n";

}  // namespace

int cps_generate(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("recipe", po::value<std::string>(), "recipe file: key = value lines")(
      "out", po::value<std::string>()->required(), "the dataset's folder")(
      "threads", po::value<int>()->default_value(tbb::info::default_concurrency()), "how many to use");
  options.add(drive_flags()).add(recipe_options());
  po::variables_map values;
  if (!parse_options(arguments, usage, options, {}, values)) return 0;
  if (values.count("recipe") > 0) store_recipe_file(values["recipe"].as<std::string>(), values);
  po::notify(values);

  if (values["threads"].as<int>() < 1) throw po::error("threads: must be at least 1");
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    values["threads"].as<int>());
  const Recipe recipe = recipe_from(values);
  const fs::path recipe_folder =
      values.count("recipe") > 0 ? fs::path(values["recipe"].as<std::string>()).parent_path() : fs::path();
  const Rig rig = find_rig(recipe.rig, recipe_folder);
  const DriveOptions drive = drive_options_from(values, recipe);
  const std::string wanted = to_text(recipe) + to_text(rig) + to_text(drive);
  const fs::path root = values["out"].as<std::string>();
  const std::vector<PlannedScene> scenes = plan_scenes(recipe, root / "scenes");
  make_scene_files(scenes);
  const std::vector<std::string> hashes = scene_hashes(scenes);
  const Job job{.fingerprint = job_fingerprint(wanted, hashes), .recipe_text = wanted};
  if (is_finished(root)) {
    require_same_job(root, job);
    std::cout << root.string() << ": is finished; nothing to do\n";
    return 0;
  }
  const Plan plan = make_plan(recipe, rig, scenes, [&](const fs::path& file) {
    DrivenScene driven = load_driven_scene(file, drive);
    if (!driven.note.empty()) std::cout << driven.note << "\n";
    return driven;
  });
  Journal journal(root, job);
  std::cout << root.string() << ": " << plan.views.size() << " views, " << plan.groups.size() << " groups, "
            << image_count(plan) << " images; " << plan.places.brief() << "\n";
  generate(plan, journal, root);
  finish_dataset(root, plan, journal.finished(), hashes);
  std::cout << root.string() << ": finished\n";
  return 0;
}

}  // namespace cps
