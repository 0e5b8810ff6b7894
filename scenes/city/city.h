#pragma once

#include <filesystem>
#include <string>

#include "scenes/city/city_options.h"

namespace cps {

struct CitySummary {
  CityStyle style = CityStyle::european;
  std::size_t streets = 0, junctions = 0, blocks = 0, buildings = 0, trees = 0, cars = 0, people = 0,
              furniture = 0;
  std::size_t in_traffic = 0;  ///< vehicles on lanes and cycle tracks, not counted in `cars`
  std::size_t lanes = 0;
  double lane_km = 0;
  std::size_t triangles = 0;            ///< stored: each shared mesh once
  std::size_t instanced_triangles = 0;  ///< rendered: each shared mesh once per node
  std::size_t bytes = 0;                ///< of the .glb file

  /// The summary as three lines of text.
  std::string brief() const;
};

/// Writes a city as binary glTF (y up, metres, textures embedded). `scenes[0].extras` holds the drivable
/// lanes (`cps_lanes`) and the style and seeds (`cps_city`). The file appears under its name only when it is
/// complete. Throws std::runtime_error with one line (what, fix) for invalid options or a file that cannot be
/// written.
CitySummary write_city(const CityOptions& options, const std::filesystem::path& file);

}  // namespace cps
