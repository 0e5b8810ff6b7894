#pragma once

#include <filesystem>
#include <string>

#include "scenes/scene.h"

namespace cps {

/// How a scene that knows no metres or lanes is made fit to drive in.
struct DriveOptions {
  double metres_per_unit = 0;   ///< 0: 1 for a scene with lanes, else guessed
  std::filesystem::path route;  ///< a CSV file with the drive (route_file.h); none: its lanes, else found
};

/// A scene in metres with lanes.
struct DrivenScene {
  Scene scene;
  double metres_per_unit = 1;  ///< of the file
  /// How it came by them, for people: `littlest.glb: 0.01 m per unit (guessed), 12 drives found, 345 m`.
  /// Empty for a scene that came with lanes in metres.
  std::string note = {};
};

/// Imports a glTF file, scales it as the options say, else leaves it when it has lanes, else by a guess, and
/// gives it lanes if it has none: the options' route, else drives found on its ground by ray casting. Throws
/// std::runtime_error in one line: file, what, fix.
DrivenScene load_driven_scene(const std::filesystem::path& file, const DriveOptions& options);

}  // namespace cps
