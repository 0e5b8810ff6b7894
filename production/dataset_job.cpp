#include "production/dataset_job.h"

#include <boost/program_options/parsers.hpp>
#include <iostream>
#include <sstream>

#include "dataset/labels/group_label.h"
#include "production/drive_options.h"
#include "production/interruption.h"
#include "production/scene_files.h"
#include "sampler/recipe/rig_file.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

fs::path city_folder(const fs::path& root) {
  return root / "scenes";
}

/// `text`, written by to_text(), as options.
po::variables_map options_of(const std::string& text, const po::options_description& known) {
  std::istringstream lines(text);
  po::variables_map values;
  po::store(po::parse_config_file(lines, known), values);
  return values;
}

/// `name` as it is, or, if that is not there, as it is in `folder`.
fs::path found_in(const fs::path& folder, const fs::path& name) {
  return fs::exists(name) ? name : folder / name;
}

std::string scenes_text(const DatasetJob& job) {
  std::string text;
  for (std::size_t s = 0; s < job.scenes.size(); ++s)
    text += "sha256 of " + job.scenes[s].file.filename().string() + " = " + job.scene_sha256[s] + "\n";
  return text;
}

}  // namespace

DatasetJob job_from_flags(const po::variables_map& values, const fs::path& root) {
  DatasetJob job{
      .recipe = recipe_from(values), .rig = {}, .drive = {}, .scenes = {}, .scene_sha256 = {}, .text = {}};
  const fs::path recipe_folder =
      values.count("recipe") > 0 ? fs::path(values["recipe"].as<std::string>()).parent_path() : fs::path();
  job.rig = find_rig(job.recipe.rig, recipe_folder);
  job.drive = drive_options_from(values, job.recipe);
  job.scenes = plan_scenes(job.recipe, city_folder(root));
  job.text = {.recipe = to_text(job.recipe),
              .rig = to_text(job.rig),
              .drive = to_text(job.drive),
              .scenes = {},
              .generator = generator_name(),
              .folder = fs::current_path()};
  return job;
}

DatasetJob job_of_folder(const fs::path& root) try {
  const Job text = read_job(root);
  DatasetJob job{.recipe = recipe_from(options_of(text.recipe, recipe_options())),
                 .rig = rig_from_text(text.rig),
                 .drive = {},
                 .scenes = {},
                 .scene_sha256 = {},
                 .text = text};
  po::options_description drive_keys = drive_flags();
  drive_keys.add_options()("route_sha256", po::value<std::string>());
  job.drive = drive_options_from(options_of(text.drive, drive_keys), job.recipe);
  if (!job.drive.route.empty()) job.drive.route = found_in(text.folder, job.drive.route);
  job.scenes = plan_scenes(job.recipe, city_folder(root));
  for (PlannedScene& scene : job.scenes)
    if (!scene.city) scene.file = found_in(text.folder, scene.file);
  return job;
} catch (const po::error& error) {
  throw std::runtime_error((root / ".cps" / "job.json").string() + ": " + error.what());
}

void prepare_scenes(DatasetJob& job, const fs::path& root) {
  make_scene_files(job.scenes, root / ".cps");
  job.scene_sha256 = scene_hashes(job.scenes);
  job.text.scenes = scenes_text(job);
  require_same_job(root, job.text);
}

Plan plan_of(const DatasetJob& job) {
  return make_plan(job.recipe, job.rig, job.scenes, [&](const fs::path& file) {
    if (is_interrupted()) throw Interrupted();
    DrivenScene driven = load_driven_scene(file, job.drive);
    if (!driven.note.empty()) std::cout << driven.note << "\n";
    return driven;
  });
}

}  // namespace cps
