#pragma once

#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/job.h"
#include "sampler/plan/plan.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// What a dataset will hold, before it is counted out.
struct DatasetJob {
  Recipe recipe;
  Rig rig;
  DriveOptions drive;
  std::vector<PlannedScene> scenes;
  std::vector<std::string> scene_sha256;  ///< parallel to scenes; empty until prepare_scenes()
  Job text;                               ///< the same, as its folder knows it
};

/// The job that flags and recipe file ask for. Nothing is read or made but recipe, rig and route. Throws
/// std::runtime_error or boost::program_options::error in one line.
DatasetJob job_from_flags(const boost::program_options::variables_map& values,
                          const std::filesystem::path& root);

/// The job that was begun in a folder. Relative names of scenes and routes are looked for where the program
/// is run, then where the job was begun. Throws std::runtime_error in one line.
DatasetJob job_of_folder(const std::filesystem::path& root);

/// Makes the procedural cities that are not there yet, and hashes all scenes. Throws std::runtime_error when
/// one is missing, or not the one that the folder's job was begun with.
void prepare_scenes(DatasetJob& job, const std::filesystem::path& root);

/// The plan of a job whose scenes are prepared; says on stdout how scenes without lanes came by them. Throws
/// as make_plan() does, and Interrupted.
Plan plan_of(const DatasetJob& job);

}  // namespace cps
