#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "scenes/city/city_style.h"

namespace cps {

/// What a procedural city is made from: the same options give the same file, byte for byte.
struct CityOptions {
  std::uint64_t seed = 0;          ///< of streets and houses; 0 is a seed like any other
  std::uint64_t traffic_seed = 0;  ///< of what moves: traffic, parked cars, people. Lanes do not know of it
  CityStyle style = CityStyle::european;
  double extent_m = 400;    ///< side length of the area with streets, metres
  double tree_density = 1;  ///< times the seed's own density; 0: no trees
  double parked_cars = 1;   ///< times the seed's own density; 0: empty kerbs
  double traffic = 1;       ///< times the share of lanes that the style fills with traffic; 0: none

  /// Whether a city can be made from these; if not, `why` (may be null) says what to change.
  bool is_valid(std::string* why) const;
};

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
