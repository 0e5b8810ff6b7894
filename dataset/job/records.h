#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sampler/recipe/dense_label.h"
#include "sensor/sensor.h"

/// Facts about the images that are measured or drawn while they are made, so the plan does not hold them. The
/// journal keeps them until the dataset is finished.
namespace cps {

/// The file of one dense label; dense_file() names it.
struct DenseRecord {
  DenseLabel label = DenseLabel::depth;
  std::uint64_t bytes = 0;  ///< of the file
  std::string sha256;       ///< of the file
};

struct ImageRecord {
  std::string file;  ///< relative to the dataset
  SensorSettings sensor;
  std::uint64_t bytes = 0;              ///< of the file
  std::string sha256;                   ///< of the file
  std::string pixels_sha256;            ///< of the decoded pixels, rows from the top
  std::vector<DenseRecord> dense = {};  ///< those of Recipe::labels, in their order
};

struct MasterRecord {
  std::string file;         ///< relative to the dataset
  std::uint64_t bytes = 0;  ///< of the file
  std::string sha256;       ///< of the file
};

/// A view whose images, with their dense labels, and kept master are all written.
struct ViewRecord {
  std::int64_t view = 0;  ///< index into Plan::views
  double exposure = 1;    ///< linear radiance → share of white; metered on what the view shows
  std::vector<ImageRecord> images;
  std::optional<MasterRecord> master = {};
};

nlohmann::ordered_json to_json(const ViewRecord& record);

/// Throws std::runtime_error (`file` first) when a key is missing or of the wrong type.
ViewRecord view_record_from_json(const nlohmann::json& json, const std::string& file);

}  // namespace cps
