#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/verify/kept_results.h"
#include "production/watch.h"
#include "sampler/plan/plan.h"

namespace cps {

struct RerenderOptions {
  int images = 0;                 ///< how many are chosen at random
  int samples = 64;               ///< per pixel
  std::uint64_t seed = 0;         ///< of the random choice
  double max_shift_px = 0.1;      ///< between a stored image and its render, beyond three times the noise
  double max_block_rms_px = 0.2;  ///< rms of the shifts of its blocks
  double min_correlation = 0.5;   ///< below it the two show different views, and their shifts mean nothing
};

/// Renders randomly chosen images again and registers each with the stored one. Camera and lens are those of
/// calibration.json, the poses of car and camera those of frames.csv, and the lens bends each ray: no master,
/// no crop, no warp. An image that agrees proves its label and its pose. Of the plan only scene, light and
/// the renderer's settings are used. Throws std::runtime_error with one line.
std::vector<RerenderedImage> rerender(const std::filesystem::path& root, const Plan& plan,
                                      const RerenderOptions& options, const Watch& watch);

}  // namespace cps
