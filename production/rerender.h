#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/verify/registration.h"
#include "production/watch.h"
#include "sampler/plan/plan.h"

namespace cps {

struct RerenderOptions {
  int images = 0;          ///< how many are drawn
  int samples = 64;        ///< per pixel
  std::uint64_t seed = 0;  ///< of the draw
  /// A stored image is at fault when it lies further off than this: as a whole, or as its blocks do, rms.
  double most_shift_px = 0.1, most_block_rms_px = 0.2;
};

struct RerenderedImage {
  std::string file;
  Registration registration;
  std::string fault;  ///< empty: agrees
};

/// Renders drawn images of a dataset again, through the lens that their calibration.json names, each ray by
/// itself: no master, no crop, no warp. What agrees proves the label against the pixels. Throws
/// std::runtime_error in one line.
std::vector<RerenderedImage> rerender(const std::filesystem::path& root, const Plan& plan,
                                      const RerenderOptions& options, const Watch& watch);

/// Writes the comparison as `.cps/rerender.json` of the dataset.
void write_report(const std::filesystem::path& root, const RerenderOptions& options,
                  const std::vector<RerenderedImage>& images);

}  // namespace cps
