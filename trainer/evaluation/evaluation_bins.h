#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numbers/interval.h"
#include "trainer/evaluation/evaluated_image.h"

namespace cps {

/// A subset of the images.
struct EvaluationBin {
  /// "H-FOV" " 60 to  70 deg"; "size" "348x128"; "camera" "front"; "lens" "K1 -0.3 to -0.2", the true k1 in
  /// apparent space.
  std::string kind, name;
  /// Of the H-FOV in degrees, or of K1, without its upper end; empty for the other kinds.
  std::optional<Interval> range{};
  int images = 0;
  LensErrors network, training_mean;
  /// 95 %, of the network's mean errors: bootstrap_intervals() over the places of the bin's images.
  Interval hfov_interval_deg{}, reprojection_interval_px{};
};

/// The bins of each kind that have an image, in the order of their values or names. `resamples` and `seed`
/// are those of the bootstrap.
std::vector<EvaluationBin> bins_of(std::span<const EvaluatedImage> images, int resamples, std::uint64_t seed);

}  // namespace cps
