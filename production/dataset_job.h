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
  std::vector<std::string> scene_sha256 = {};  ///< parallel to scenes; empty until prepare_scenes()
  Job text;                                    ///< the same as the dataset's folder keeps it
};

/// A job that is begun in the folder `root` from the current folder. Reads nothing but the drive's route.
/// Throws std::runtime_error in one line when it cannot be read.
DatasetJob new_job(const Recipe& recipe, const Rig& rig, const DriveOptions& drive,
                   const std::filesystem::path& root);

/// The job that was begun in the folder `root`. Relative names of scenes and routes are looked for in the
/// current folder, then in the one where the job was begun. Throws std::runtime_error in one line.
DatasetJob job_of_folder(const std::filesystem::path& root);

/// Makes the procedural cities whose files are missing, and hashes all scenes. Throws std::runtime_error when
/// a scene is missing or is not the one that the folder's job was begun with.
void prepare_scenes(DatasetJob& job, const std::filesystem::path& root);

/// Whether the files of all scenes exist.
bool has_scenes(const DatasetJob& job);

/// The plan of a job whose scenes are prepared; the watch hears of each scene as in load_scene(). Throws as
/// make_plan() does, and Interrupted when the watch stops it.
Plan plan_of(const DatasetJob& job, const Watch& watch);

}  // namespace cps
