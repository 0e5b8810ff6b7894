#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// `--metres_per_unit` and `--route`: how the recipe's scenes are made fit to drive in.
boost::program_options::options_description drive_flags();

/// What the flags say, checked against the recipe. Throws boost::program_options::error in one line.
DriveOptions drive_options_from(const boost::program_options::variables_map& values, const Recipe& recipe);

/// What a job's fingerprint and its first difference know of them, the route's contents included.
std::string to_text(const DriveOptions& drive);

}  // namespace cps
