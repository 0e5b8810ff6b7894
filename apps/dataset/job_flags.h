#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/manual/manual.h"
#include "production/dataset_job.h"

namespace cps {

/// Parses the arguments of a verb that works on a recipe: its own `options`, and those of every such verb,
/// which are `--recipe`, the recipe's keys, `--threads`, and `--metres_per_unit`, `--up`, `--route` and
/// `--look`, which say how cars drive through the scenes and show it. Stores the keys of the recipe's file.
/// False after --help. Throws as parse_options() and store_named_recipe() do.
bool parse_job_options(const std::vector<std::string>& arguments, const Manual& manual,
                       boost::program_options::options_description options,
                       boost::program_options::variables_map& values);

/// The job that parsed options ask for, begun in the folder `root`. Reads the files of recipe, rig and route
/// and nothing else. Throws std::runtime_error or
/// boost::program_options::error in one line.
DatasetJob job_from_flags(const boost::program_options::variables_map& values,
                          const std::filesystem::path& root);

/// Makes the watch write top views of the scenes into the folder that `--look` names, if it is given.
void look_with_flags(const boost::program_options::variables_map& values, Watch& watch);

}  // namespace cps
