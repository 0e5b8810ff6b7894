#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "distortion/models/lens_model.h"
#include "distortion/pinhole.h"

namespace cps {

/// The lens that --lens names.
struct LensChoice {
  LensModel lens;
  std::optional<Pinhole> calibrated = {};  ///< the camera of a calibration file; none with coefficients

  /// Whether its pictures can be warped from a flat master.
  bool is_brown_conrady() const { return std::holds_alternative<Distortion>(lens); }
};

/// Reads "k1=…,p2=…" (Brown–Conrady), "FAMILY:name=value,…", or else a calibration file, of which
/// `camera_name` chooses a camera if it holds several. Throws boost::program_options::error for parameters
/// that are none, std::runtime_error in one line for a file that cannot be read.
LensChoice lens_choice(const std::string& text, const std::string& camera_name);

}  // namespace cps
