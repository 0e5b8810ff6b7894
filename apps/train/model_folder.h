#pragma once

#include <boost/program_options/variables_map.hpp>
#include <filesystem>

namespace cps {

/// The folder that `--model` names, which is not checked, or without `--model` the reference model:
/// `cps-reference` in the folder that the environment variable CPS_MODEL_DIR names, or else in `models` of
/// share_folder(). A place counts if it holds the model's model.json. Throws std::runtime_error with one line
/// that names the places if none does.
std::filesystem::path model_folder_of(const boost::program_options::variables_map& values);

}  // namespace cps
