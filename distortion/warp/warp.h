#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <functional>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/certificate/certificate.h"
#include "distortion/pinhole.h"
#include "distortion/warp/footprints.h"

namespace cps {

/// How one output pixel is made from the source.
enum class Resampling {
  footprint,  ///< colour and anything else that may be averaged
  nearest,    ///< ids: the source pixel that the ray through the pixel's centre meets, bit for bit, any pixel
              ///< type
  depth,      ///< z along the optical axis: exact on planes, never averaged across an edge
};

struct WarpOptions {
  double oversampling = 2;       ///< of the master, per axis
  double kernel_sigma_px = 0.5;  ///< standard deviation of the output pixel's kernel, output pixels
  Resampling resampling = Resampling::footprint;
  /// Ideal points among which the inverse is looked for; the lens must be one-to-one on them. A crop's base
  /// frame is the part that it was certified on. Empty: the smallest part of the master that will do.
  Eigen::AlignedBox2d box = {};
  bool require_coverage = true;  ///< throw if a footprint leaves the source; otherwise such pixels are 0
  /// Throw where the image is magnified beyond what the source carries; otherwise the kernel is widened
  /// there.
  bool require_resolution = true;
  bool is_valid(std::string* why) const;
};

/// Margin that a master needs on each side, master pixels, so that every footprint of a border-free crop lies
/// inside it: support · sigma · oversampling / min_eigenvalue, rounded up.
int master_pad(const WarpOptions& options, double min_eigenvalue);

/// The camera that renders the master for `base`: oversampled and padded.
Pinhole master_camera(const Pinhole& base, const WarpOptions& options, double min_eigenvalue);

/// Largest zoom · eigenvalue up to which the master carries the kernel: CropOptions::max_magnification.
double largest_magnification(const WarpOptions& options);

/// Asked of a lens by warp() and unwarp(): where it shrinks or enlarges more, a pixel has no sensible
/// footprint.
inline constexpr CertificateOptions warpable{.min_eigenvalue = 0.01, .max_eigenvalue = 100};

struct WarpSummary {
  double worst_residual_px = 0;         ///< of the inversion, pixels of the distorted image
  std::int64_t uncovered_pixels = 0;    ///< whose footprint leaves the source
  std::int64_t fallbacks = 0;           ///< pixels that the vectorised inverse handed to the robust one
  double smallest_kernel_sigma_px = 0;  ///< source pixels; infinite for ids and depth
  double seconds = 0;
  std::string brief() const;
};

/// The image that the lens shows at `output` of an ideal image, resampled once: each output pixel is a
/// kernel-weighted mean over its true footprint in the master (footprints.h), so that sharpness and noise do
/// not follow the local magnification. An undistorted lens takes exactly the same path. `master` has 1–4
/// channels of any pixel type, linear, finite; the result has the same type. The same bytes for any number of
/// threads.
///
/// Throws std::runtime_error with one line: options, sizes that do not match, a lens that is not one-to-one
/// on the master, footprints that leave the master, magnification above what the master carries.
OIIO::ImageBuf warp(const OIIO::ImageBuf& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

/// Done to the kernels of a tile before anything is gathered through them.
using FootprintChange = std::function<void(FootprintTile& tile)>;

/// As warp(), through other kernels at the same places; no change: warp() itself.
OIIO::ImageBuf warp_through(const FootprintChange& change, const OIIO::ImageBuf& master,
                            const Pinhole& master_camera, const Distortion& lens, const Pinhole& output,
                            const WarpOptions& options, WarpSummary* summary = nullptr);

/// The other way: the ideal image at `output` of one that was seen through the lens at `camera`. What the
/// source does not show, or only beyond a fold, is 0; if coverage is required, it is an
/// error.
OIIO::ImageBuf unwarp(const OIIO::ImageBuf& source, const Pinhole& camera, const Distortion& lens,
                      const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
