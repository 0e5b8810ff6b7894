#pragma once

#include <boost/program_options/variables_map.hpp>

namespace cps {

/// Adds the keys of the recipe that `--recipe` names, if given, to `values`, and replaces the name by its
/// path: an existing file, or else the name of a shipped recipe (`cps-v2`), looked for in
/// `recipes` of share_folder(). Throws as store_recipe_file() does.
void store_named_recipe(boost::program_options::variables_map& values);

}  // namespace cps
