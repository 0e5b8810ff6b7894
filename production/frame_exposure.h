#pragma once

#include <span>
#include <string>
#include <vector>

#include "sensor/photograph.h"

namespace cps {

/// What a view's exposure makes of it.
enum class FrameExposure {
  good,
  near_black,  ///< less than a twentieth of the pixels reach 1 % of white
  blown_out    ///< more than half of them are white
};

/// Judges a master of three channels by its own exposure, without a sensor's deviation from it.
FrameExposure frame_exposure(const Master& master);

/// Judges images that share an exposure, all their valid pixels together.
FrameExposure frame_exposure(std::span<const MeteredImage> images, double exposure);

/// Views that came out badly exposed, by name.
struct BadlyExposed {
  std::vector<std::string> near_black, blown_out;

  void add(FrameExposure exposure, const std::string& view);
  /// A line a kind, for the user: how many views, the first one's name, and what to look at; none if all are
  /// good.
  std::vector<std::string> warnings() const;
};

}  // namespace cps
