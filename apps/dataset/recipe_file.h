#pragma once

#include <boost/program_options/variables_map.hpp>

namespace cps {

/// Adds to `values` the keys of the recipe that `--recipe` names, if it does, and makes the name a path: the
/// file as it stands there, else a shipped recipe's name (`cps-v2`), looked for in ../share/cps/recipes from
/// the program. Throws as store_recipe_file() does.
void store_named_recipe(boost::program_options::variables_map& values);

}  // namespace cps
