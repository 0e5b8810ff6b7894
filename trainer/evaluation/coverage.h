#pragma once

#include <array>
#include <span>

#include "trainer/calibration/targets.h"

/// Whether the standard deviations that a network states are those of its errors.
namespace cps {

/// Points of a reliability curve, and the number of standard deviations of each: .25, .5, … 3.
inline constexpr int reliability_points = 12;
constexpr double reliability_deviations(int point) {
  return .25 * (point + 1);
}

/// The share of a normal distribution within so many standard deviations of its mean.
double normal_share(double deviations);

/// How often a network's standard deviations hold its errors.
struct Coverage {
  Outputs within_one{}, within_two{};  ///< share of the images, for each output, raw; normal: .683, .954
  /// √(mean of error² / variance): 1 if the deviations are right, more if they are too small.
  Outputs scaled_error{};
  /// Share of the images within reliability_deviations() of each point; right deviations of normal errors
  /// give normal_share() of that.
  std::array<Outputs, reliability_points> within{};
};

/// Entry i of both arguments belongs to image i. Needs at least one image.
Coverage coverage_of(std::span<const Outputs> errors, std::span<const Outputs> deviations);

}  // namespace cps
