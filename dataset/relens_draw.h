#pragma once

#include <string>
#include <vector>

#include "dataset/labels/label.h"
#include "distortion/image_size.h"
#include "sampler/lenses/lens_options.h"

/// Lenses for pictures that are there already, straightened: real pixels with exact labels.
namespace cps {

struct RelensOptions {
  int lenses = 8;          ///< for each camera
  ImageSize size{0, 0};    ///< of the output; 0: half the picture's, rounded down
  double narrowest = 0.5;  ///< base H-FOV at least, as a share of the widest that fits
  std::uint64_t seed = 0;
  LensOptions lens;
  bool is_valid(std::string* why) const;
};

/// A leaf folder of the dataset.
struct RelensGroup {
  std::string folder;  ///< <size>_hfov<the straight picture's>/<camera>_lens<number>
  Label label;         ///< part: test
};

/// Lenses `first_lens`, … for straight pictures taken at `straight` (square pixels, centred). Each has a base
/// of its own inside the picture, of an H-FOV uniform between `narrowest` times the widest that fits and
/// that, and the border-free crop of it. One whose footprints leave the picture, or that enlarges it more
/// than the warp's kernel allows, is drawn again as a whole. A pure function of the arguments. Throws
/// std::runtime_error when none is found.
std::vector<RelensGroup> draw_relens_groups(const Pinhole& straight, const std::string& camera,
                                            int first_lens, const RelensOptions& options);

}  // namespace cps
