#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

namespace cps {

struct RegistrationOptions {
  int block_px = 48;  ///< approximate side of the blocks
  /// Blocks whose shift has a larger standard deviation than this are left out.
  double max_noise_px = 0.1;
};

/// How far two pictures of the same scene are apart.
struct Registration {
  double shift_x_px = 0, shift_y_px = 0;  ///< of the whole picture, second against first
  double shift_noise_px = 0;              ///< its standard deviation, estimated from the pictures' difference
  int blocks = 0;                         ///< that were not left out
  double block_rms_px = 0;                ///< rms shift of the blocks, beyond what their noise explains
  double worst_block_px = 0;              ///< largest shift of a block, beyond its noise
  /// Correlation of the smoothed values about the mean of their block, over all blocks: near 1 for pictures
  /// of one view, near 0 for others, where the shifts mean nothing.
  double correlation = 0;
  double psnr_db = 0;  ///< of values with white at 1
};

/// Subpixel registration of two pictures of one float channel and the same size, which differ by little more
/// than noise: one Gauss–Newton step on the brightness difference (Lucas & Kanade 1981), over all pixels and
/// over blocks, after smoothing both (binomial 5×5), with the mean of both gradients and Huber weights for
/// differences beyond three times their median. Throws std::runtime_error when the sizes differ.
Registration register_pictures(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second,
                               const RegistrationOptions& options = {});

}  // namespace cps
