#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cps {

/// What dataset.json says, as far as a report shows it.
struct Description {
  struct Camera {
    std::string name;
    Eigen::Matrix4d vehicle_from_camera;
  };
  struct City {
    std::string style;
    std::uint64_t seed = 0, traffic_seed = 0;
    double traffic = 0;
  };
  struct Scene {
    std::string file, credits, sha256;
    double metres_per_unit = 1;
    std::optional<City> city = {};
    std::vector<std::string> import_warnings = {};
  };
  struct Condition {
    std::string scene, date, time_utc, weather;
    double sun_elevation_deg = 0, sun_azimuth_deg = 0, turbidity = 0;
    std::string streets;  ///< name of the map that its places lie on, see streets_of()
  };
  struct Places {
    std::int64_t drawn = 0, rejected = 0;
    std::vector<std::pair<std::string, std::int64_t>> rejected_for = {};
  };
  std::string name, generator;
  std::uint64_t schema = 0, seed = 0;
  std::vector<std::pair<std::string, std::string>> recipe;  ///< key and text
  std::vector<Camera> rig;
  std::vector<Scene> scenes;
  std::vector<Condition> conditions;
  std::int64_t views = 0;
  std::optional<Places> places = {};
  std::array<std::string, 3> pixels_sha256;  ///< of train, val and test
};

/// Checks and reads dataset.json. Throws std::runtime_error with one line: `file`, key, what is wrong.
Description description_from_json(const nlohmann::json& json, const std::string& file);

}  // namespace cps
