#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

namespace cps {

struct RegistrationOptions {
  int block_px = 48;  ///< side of the blocks, about
  double most_noise_px =
      0.1;  ///< blocks whose shift is less certain than this (standard deviation) do not count
};

/// How far two pictures of the same thing are apart.
struct Registration {
  double shift_x_px = 0, shift_y_px = 0;  ///< of the whole, second against first
  double shift_noise_px = 0;  ///< its standard deviation, as the difference of the pictures has it
  int blocks = 0;             ///< that count
  double block_rms_px = 0;    ///< shifts of the blocks, what their noise explains taken off
  double worst_block_px = 0;  ///< likewise
  double psnr_db = 0;         ///< of values with white at 1
};

/// Subpixel registration of two pictures with one float channel and one size, which differ by little more
/// than noise: Gauss–Newton on the brightness difference (Lucas & Kanade 1981), over all pixels and over
/// blocks, both smoothed first (binomial 5×5) and with the mean of both gradients; differences beyond three
/// times their median count as that (Huber). Throws std::runtime_error when the sizes differ.
Registration register_pictures(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second,
                               const RegistrationOptions& options = {});

}  // namespace cps
