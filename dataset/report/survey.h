#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dataset/report/description.h"
#include "dataset/report/distribution.h"
#include "dataset/verify/dataset_files.h"
#include "sampler/recipe/recipe.h"

namespace cps {

/// Where a car stood, seen from above.
struct MapPlace {
  Part part = Part::train;
  double x_m = 0, z_m = 0;  ///< world: east, south
  double heading_rad = 0;   ///< from east to north
  auto operator<=>(const MapPlace&) const = default;
};

/// What all frames.csv say, added up.
struct FrameSurvey {
  std::vector<std::int64_t> images_of_condition;
  std::map<std::string, std::set<MapPlace>> places;  ///< by the map that they lie on, each place once
  std::array<std::set<std::string>, 3> streets;      ///< by part: map and street
  std::vector<Distribution> distributions;           ///< of poses, exposures and sensors
};

/// A dataset, read for its report.
struct DatasetSurvey {
  DatasetFiles files;  ///< its frames and images are not read
  /// These are empty for a set that cps relens made: it has no dataset.json and no frames.csv.
  std::optional<Description> description = {};
  std::optional<Recipe> recipe = {};
  std::optional<FrameSurvey> frames = {};
  std::vector<std::int64_t> images_of_group = {};
  std::vector<Distribution> labels = {};  ///< distributions of the numbers in calibration.json
};

/// Reads a finished dataset, no pixels, and of frames.csv one file at a time. Throws std::runtime_error with
/// one line: folder or file, what is wrong.
DatasetSurvey survey_dataset(const std::filesystem::path& root);

}  // namespace cps
