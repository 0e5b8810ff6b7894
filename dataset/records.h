#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sensor/develop.h"

/// What was found out while making the images and the plan does not know. The journal keeps it until the
/// dataset is finished.
namespace cps {

struct ImageRecord {
  std::string file;  ///< relative to the dataset
  SensorSettings sensor;
  std::uint64_t bytes = 0;    ///< of the file
  std::string sha256;         ///< of the file
  std::string pixels_sha256;  ///< of the decoded pixels, rows from the top
};

/// A view all of whose images are under their final names.
struct ViewRecord {
  std::int64_t view = 0;  ///< index into Plan::views
  double exposure = 1;    ///< metered on the master
  std::vector<ImageRecord> images;
};

nlohmann::ordered_json to_json(const ViewRecord& record);

/// Throws std::runtime_error (`file` first) when a key is missing or of the wrong type.
ViewRecord view_record_from_json(const nlohmann::json& json, const std::string& file);

}  // namespace cps
