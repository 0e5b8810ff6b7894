#include "production/dataset_job.h"

#include <algorithm>
#include <boost/program_options/parsers.hpp>
#include <numeric>
#include <sstream>

#include "dataset/labels/group_label.h"
#include "files/pieces.h"
#include "production/drive_text.h"
#include "production/load_scene.h"
#include "production/scene_files.h"
#include "sampler/plan/place_views.h"
#include "sampler/recipe/rig_file.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

fs::path city_folder(const fs::path& root) {
  return root / "scenes";
}

/// A recipe as to_text() wrote it.
Recipe recipe_from_text(const std::string& text) {
  std::istringstream lines(text);
  po::variables_map values;
  po::store(po::parse_config_file(lines, recipe_options()), values);
  return recipe_from(values);
}

/// `name`, or, if there is no such file, `name` in `folder`.
fs::path found_in(const fs::path& folder, const fs::path& name) {
  return fs::exists(name) ? name : folder / name;
}

std::string scenes_text(const DatasetJob& job) {
  std::string text;
  for (std::size_t s = 0; s < job.scenes.size(); ++s)
    text += "sha256 of " + job.scenes[s].file.filename().string() + " = " + job.scene_sha256[s] + "\n";
  return text;
}

/// Makes and hashes the files of some scenes, indices into job.scenes, and compares with the folder's job.
void prepare(DatasetJob& job, const std::vector<int>& scenes, const fs::path& root) {
  std::vector<PlannedScene> wanted;
  for (int s : scenes) wanted.push_back(job.scenes[s]);
  make_scene_files(wanted, root / ".cps");
  job.scene_sha256.resize(job.scenes.size());
  for (int s : scenes) job.scene_sha256[s] = sha256_of_file(job.scenes[s].file);
  job.text.scenes = scenes_text(job);
  require_same_job(root, job.text);
}

LoadDrivenScene loader_of(const DatasetJob& job, const Watch& watch) {
  return [&](const fs::path& file) { return load_scene(file, job.drive, watch); };
}

}  // namespace

DatasetJob new_job(const Recipe& recipe, const Rig& rig, const DriveOptions& drive, const fs::path& root) {
  return {.recipe = recipe,
          .rig = rig,
          .drive = drive,
          .scenes = plan_scenes(recipe, city_folder(root)),
          .text = {.recipe = to_text(recipe),
                   .rig = to_text(rig),
                   .drive = to_text(drive),
                   .generator = generator_name(),
                   .folder = fs::current_path()}};
}

DatasetJob job_of_folder(const fs::path& root) try {
  const Job text = read_job(root);
  const Recipe recipe = recipe_from_text(text.recipe);
  DatasetJob job{.recipe = recipe,
                 .rig = rig_from_text(text.rig),
                 .drive = drive_from_text(text.drive),
                 .scenes = plan_scenes(recipe, city_folder(root)),
                 .text = text};
  if (const std::string fault = fault_of(job.drive, recipe); !fault.empty()) throw po::error(fault);
  if (!job.drive.route.empty()) job.drive.route = found_in(text.folder, job.drive.route);
  for (PlannedScene& scene : job.scenes)
    if (!scene.city) scene.file = found_in(text.folder, scene.file);
  return job;
} catch (const po::error& error) {
  throw std::runtime_error((root / ".cps" / "job.json").string() + ": " + error.what());
}

void require_scenes(const DatasetJob& job) {
  require_given_files(job.scenes);
}

void prepare_scenes(DatasetJob& job, const fs::path& root) {
  std::vector<int> all(job.scenes.size());
  std::iota(all.begin(), all.end(), 0);
  prepare(job, all, root);
}

bool has_scenes(const DatasetJob& job) {
  return std::ranges::all_of(job.scenes, [](const PlannedScene& scene) { return fs::exists(scene.file); });
}

Plan outline_of(const DatasetJob& job) {
  return outline_plan(job.recipe, job.rig, job.scenes);
}

void prepare_views(DatasetJob& job, Plan& plan, const std::vector<std::int64_t>& views, const fs::path& root,
                   const Watch& watch) {
  prepare(job, scenes_of(plan, views), root);
  place_views(plan, views, loader_of(job, watch));
}

Plan plan_of(const DatasetJob& job, const Watch& watch) {
  return make_plan(job.recipe, job.rig, job.scenes, loader_of(job, watch));
}

}  // namespace cps
