#include "apps/train/model_folder.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/share_folder.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

constexpr const char* reference_model = "cps-reference";

/// The folders of models in which it is looked for, in this order.
std::vector<fs::path> model_places() {
  std::vector<fs::path> places;
  if (const char* folder = std::getenv("CPS_MODEL_DIR"); folder && *folder) places.emplace_back(folder);
  places.push_back(share_folder() / "models");
  return places;
}

}  // namespace

fs::path model_folder_of(const boost::program_options::variables_map& values) {
  if (values.count("model") > 0) return values["model"].as<std::string>();
  std::string looked_in;
  for (const fs::path& place : model_places()) {
    if (fs::exists(place / reference_model / "model.json")) return place / reference_model;
    looked_in += (looked_in.empty() ? "" : " or ") + place.string();
  }
  throw std::runtime_error(std::string(reference_model) + ": there is no such model in " + looked_in +
                           ": name a model folder by --model, or by CPS_MODEL_DIR the folder that holds " +
                           reference_model);
}

}  // namespace cps
