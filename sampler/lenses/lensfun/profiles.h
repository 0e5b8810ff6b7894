#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "distortion/brown_conrady.h"

/// The distortion profiles of the Lensfun database (https://lensfun.github.io, data under CC BY-SA 3.0), read
/// from the folder of Debian's liblensfun-data-v1. This project ships only numbers fitted to them.
namespace cps {

/// One measured setting of one lens, in the database's terms (version 1): with half the frame's short side as
/// the unit of length, an undistorted radius u is seen at u (d + c u + b u² + a u³ + k u⁴).
struct LensfunProfile {
  double aspect = 1.5;                    ///< of the frame, long side / short side
  double hfov_deg = 0;                    ///< 2·atan(long side / 2 focal length)
  std::array<double, 5> polynomial = {};  ///< d c b a k
};

/// Every distortion row of every rectilinear lens in the folder's .xml files. Throws std::runtime_error
/// naming the file that cannot be read, and when there is none.
std::vector<LensfunProfile> read_lensfun(const std::filesystem::path& folder);

/// A profile as Brown–Conrady lens. The profile's focal length is taken as the paraxial one.
struct ConvertedProfile {
  Distortion lens;              ///< in units of the half diagonal of its base's frame
  double largest_residual = 0;  ///< of the least-squares fit of k1 k2 k3, in that unit
};

/// Empty if the profile folds inside its frame, or exceeds the limits of CertificateOptions{}.
std::optional<ConvertedProfile> converted(const LensfunProfile& profile);

}  // namespace cps
