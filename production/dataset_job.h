#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/job.h"
#include "production/watch.h"
#include "sampler/plan/plan.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// All that decides a dataset's bytes, before it is planned.
struct DatasetJob {
  Recipe recipe;
  Rig rig;
  DriveOptions drive;
  std::vector<PlannedScene> scenes;
  std::vector<std::string> scene_sha256 = {};  ///< parallel to scenes; empty for those not yet prepared
  Job text;                                    ///< the same as the dataset's folder keeps it
};

/// A job that is begun in the folder `root` from the current folder. Reads nothing but the drive's route.
/// Throws std::runtime_error in one line when it cannot be read.
DatasetJob new_job(const Recipe& recipe, const Rig& rig, const DriveOptions& drive,
                   const std::filesystem::path& root);

/// The job that was begun in the folder `root`. Relative names of scenes and routes are looked for in the
/// current folder, then in the one where the job was begun. Throws std::runtime_error in one line.
DatasetJob job_of_folder(const std::filesystem::path& root);

/// Throws std::runtime_error in one line when the file of a scene that is no procedural city is missing.
void require_scenes(const DatasetJob& job);

/// Makes the procedural cities whose files are missing, and hashes all scenes. Throws std::runtime_error when
/// a scene is missing or is not the one that the folder's job was begun with.
void prepare_scenes(DatasetJob& job, const std::filesystem::path& root);

/// Whether the files of all scenes exist.
bool has_scenes(const DatasetJob& job);

/// The plan of a job but for the places of its views. Reads no scene.
Plan outline_of(const DatasetJob& job);

/// Prepares the scenes of some views (ascending) and places these views in the plan. Looks at no other scene.
/// The watch hears of each scene as in load_scene(). Throws as prepare_scenes() and place_views() do, and
/// Interrupted when the watch stops it.
void prepare_views(DatasetJob& job, Plan& plan, const std::vector<std::int64_t>& views,
                   const std::filesystem::path& root, const Watch& watch);

/// The plan of a job whose scenes are prepared. The watch hears of each scene as in load_scene(). Throws as
/// place_views() does, and Interrupted when the watch stops it.
Plan plan_of(const DatasetJob& job, const Watch& watch);

}  // namespace cps
