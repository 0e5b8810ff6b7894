#pragma once

#include <filesystem>
#include <string>

#include "scenes/city/city_options.h"

namespace cps {

struct CitySummary {
  CityStyle style = CityStyle::european;
  std::size_t streets = 0, junctions = 0, blocks = 0, buildings = 0, trees = 0, cars = 0, people = 0,
              furniture = 0;
  std::size_t in_traffic = 0;  ///< vehicles on the lanes, which `cars` does not count
  std::size_t lanes = 0;
  double lane_km = 0;
  std::size_t triangles = 0;            ///< stored, each shared mesh once
  std::size_t instanced_triangles = 0;  ///< as seen, each shared mesh as often as it stands somewhere
  std::size_t bytes = 0;                ///< of the file

  /// A few lines for people.
  std::string brief() const;
};

/// Writes a city as glTF binary (y up, metres; textures inside; drivable lanes in
/// `scenes[0].extras.cps_lanes`, what it is made from in `cps_city`). The file appears under its name only
/// when it is complete. Throws std::runtime_error (invalid options, unwritable file) with one line that says
/// what to change.
CitySummary write_city(const CityOptions& options, const std::filesystem::path& file);

}  // namespace cps
