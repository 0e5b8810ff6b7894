#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>

#include "production/dataset_job.h"

namespace cps {

/// `--metres_per_unit` and `--route`: how cars drive through the recipe's scenes.
boost::program_options::options_description drive_flags();

/// The job that `--recipe`, the recipe's keys and drive_flags() ask for, begun in the folder `root`. Reads
/// the files of recipe, rig and route and nothing else. Throws std::runtime_error or
/// boost::program_options::error in one line.
DatasetJob job_from_flags(const boost::program_options::variables_map& values,
                          const std::filesystem::path& root);

}  // namespace cps
