#pragma once

#include <string>
#include <vector>

#include "dataset/labels/label.h"
#include "distortion/image_size.h"
#include "sampler/lenses/lens_options.h"

/// Draws lenses for existing pictures after their own lens was undone: real pixels with exact labels.
namespace cps {

struct RelensOptions {
  int lenses = 8;          ///< for each camera
  ImageSize size{0, 0};    ///< of the output; 0: half the picture's, rounded down
  double narrowest = 0.5;  ///< smallest base H-FOV, as a share of the widest that fits into the picture
  std::uint64_t seed = 0;
  LensOptions lens = {};
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// A leaf folder of the dataset.
struct RelensGroup {
  std::string folder;  ///< <size>_hfov<the straight picture's>/<camera>_lens<number>
  Label label;         ///< part: test
};

/// Draws `options.lenses` lenses, numbered from `first_lens`, for undistorted pictures of the camera
/// `straight` (square pixels, centred principal point). Each lens has its own base inside the picture, whose
/// H-FOV is uniform between `narrowest` times the widest that fits and that, and the border-free crop of it.
/// A lens whose pixels would reach beyond the picture, or that enlarges it more than the warp's kernel
/// allows, is drawn again as a whole. A pure function of the arguments. Throws std::runtime_error when no
/// lens is found.
std::vector<RelensGroup> draw_relens_groups(const Pinhole& straight, const std::string& camera,
                                            int first_lens, const RelensOptions& options);

}  // namespace cps
