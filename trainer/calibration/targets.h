#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

/// What the network predicts: eight numbers per image, in the order published CPS models use.
namespace cps {

inline constexpr int output_count = 8;
using Outputs = std::array<double, output_count>;
inline constexpr std::array<const char*, output_count> output_names{"fov", "k1", "k2", "k3",
                                                                    "p1",  "p2", "cx", "cy"};

/// raw: H-FOV in radians, k1 k2 k3 p1 p2 as they are, cx/width, cy/height.
/// apparent: the same, but coefficients scaled by the frame's half diagonal R on the plane z = 1
/// (k1 R², k2 R⁴, k3 R⁶, p R), which says how much the picture bends: raw coefficients of one and the same
/// bend grow without bound as the view narrows.
enum class TargetSpace { raw, apparent };

std::string to_string(TargetSpace space);
/// Throws std::runtime_error on any other word.
TargetSpace target_space_from_string(const std::string& word);

/// A camera and its lens: what a label says, or a network.
struct Calibration {
  Pinhole camera;
  Distortion distortion;
};

Outputs to_outputs(const Calibration& calibration, TargetSpace space);

/// The calibration that `outputs` says for an image of this size, with square pixels (eight numbers hold one
/// focal length). Empty when they say none: a number that is not finite, or an H-FOV outside (0°, 180°).
std::optional<Calibration> to_calibration(const Outputs& outputs, TargetSpace space, int width, int height);

/// The same outputs in another space, for an image of this size.
Outputs convert(const Outputs& outputs, TargetSpace from, TargetSpace to, int width, int height);

/// Makes every target zero-mean and of unit variance over the training set, so that each weighs alike in a
/// squared loss.
struct Standardisation {
  Outputs mean{};
  Outputs deviation{};  ///< 1 where the training set does not vary: that output then learns its constant
};

Standardisation fit_standardisation(std::span<const Outputs> targets);
Outputs standardise(const Outputs& outputs, const Standardisation& by);
Outputs unstandardise(const Outputs& outputs, const Standardisation& by);

}  // namespace cps
