#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "distortion/calibrated_camera.h"

/// The network's outputs: eight numbers per image, in the order published CPS models use.
namespace cps {

inline constexpr int output_count = 8;
using Outputs = std::array<double, output_count>;
inline constexpr std::array<const char*, output_count> output_names{"fov", "k1", "k2", "k3",
                                                                    "p1",  "p2", "cx", "cy"};

/// raw: H-FOV in radians, k1 k2 k3 p1 p2 as they are, cx/width, cy/height.
/// apparent: the same, but coefficients scaled by the frame's half diagonal R on the plane z = 1
/// (k1 R², k2 R⁴, k3 R⁶, p R). That measures the visible bend: the raw coefficients of one and the same
/// visible bend grow without bound as the H-FOV shrinks.
/// seen: as apparent, but with the H-FOV that the image sees (calibration/seen_hfov.h) instead of the
/// label's.
enum class TargetSpace { raw, apparent, seen };

std::string to_string(TargetSpace space);
/// Throws std::runtime_error on any other word.
TargetSpace target_space_from_string(const std::string& word);

/// The outputs that describe `camera`, in `space`.
Outputs to_outputs(const CalibratedCamera& camera, TargetSpace space);

/// The camera (without a name) that `outputs` describe, for an image of this size in pixels. Its pixels are
/// square, because eight numbers hold one focal length. Empty if a number is not finite or the H-FOV lies
/// outside (0°, 180°).
std::optional<CalibratedCamera> to_camera(const Outputs& outputs, TargetSpace space, int width, int height);

/// The same outputs in another space, for an image of this size in pixels.
Outputs convert(const Outputs& outputs, TargetSpace from, TargetSpace to, int width, int height);

/// Shifts and scales every target to zero mean and unit variance over the training set, so that all have the
/// same weight in a squared loss.
struct Standardisation {
  Outputs mean{};
  Outputs deviation{};  ///< 1 where the training set does not vary
};

/// Mean and standard deviation of each output over `targets`, of which there must be at least one.
Standardisation fit_standardisation(std::span<const Outputs> targets);

/// (outputs − mean) / deviation.
Outputs standardise(const Outputs& outputs, const Standardisation& by);

/// mean + deviation · outputs.
Outputs unstandardise(const Outputs& outputs, const Standardisation& by);

}  // namespace cps
