#pragma once

#include <filesystem>
#include <string>

#include "scenes/scene.h"

namespace cps {

/// How to scale a scene to metres and give it lanes.
struct DriveOptions {
  double metres_per_unit = 0;   ///< 0: automatic: 1 for a scene with lanes, else guessed
  bool is_z_up = false;         ///< the file's z points up, against glTF's rule; route files, too
  std::filesystem::path route;  ///< CSV file (route_file.h); empty: the scene's lanes, else found drives
};

/// A scene in metres, with lanes.
struct DrivenScene {
  Scene scene;
  double metres_per_unit = 1;  ///< of the file's units
  bool is_z_up = false;        ///< the file is, and has been turned
  /// How scale and lanes were found, and why there, as a line to print: `littlest.glb: 0.01 m per unit
  /// (guessed from its size), 12 drives found, 345 m on ground at y = 0.2 m with things in 71 % of all
  /// directions, the best of 3 grounds`. Empty for a scene whose file has lanes in metres.
  std::string note = {};
};

/// Imports a glTF file, scales it to metres and gives it lanes. Scale: that of the options; else 1 if the
/// file has lanes; else a guess. Lanes: the route of the options; else the file's; else drives found on its
/// ground by ray casting. Throws std::runtime_error with one line: file, what, fix.
DrivenScene load_driven_scene(const std::filesystem::path& file, const DriveOptions& options);

}  // namespace cps
