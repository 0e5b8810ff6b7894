#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/certificate/certificate.h"

namespace cps {

/// How one output pixel is made from the source.
enum class Resampling {
  footprint,  ///< kernel-weighted mean: colour and anything else that may be averaged
  nearest,    ///< ids: the source pixel that the ray through the pixel's centre meets, bit for bit, any pixel
              ///< type
  depth,      ///< z along the optical axis: exact on planes, never averaged across an edge
};

struct WarpOptions {
  double oversampling = 2;       ///< of the master, per axis
  double kernel_sigma_px = 0.5;  ///< standard deviation of the output pixel's kernel, output pixels
  Resampling resampling = Resampling::footprint;
  /// Ideal points among which the inverse is looked for; the lens must be one-to-one on them. For a crop: the
  /// base frame, on which the lens was certified. Empty: the smallest part of the master that will do.
  Eigen::AlignedBox2d box = {};
  bool require_coverage = true;  ///< throw if a footprint leaves the source; otherwise such pixels are 0
  /// Throw where the image is magnified beyond what the source carries; otherwise widen the kernel there.
  bool require_resolution = true;

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// What warp() and unwarp() require of a lens: where it shrinks or enlarges more, a pixel has no sensible
/// footprint.
inline constexpr CertificateOptions warpable{.min_eigenvalue = 0.01, .max_eigenvalue = 100};

}  // namespace cps
