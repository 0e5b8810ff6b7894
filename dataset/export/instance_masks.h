#pragma once

#include <OpenImageIO/imagebuf.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cps {

/// The pixels of one object that are of one class.
struct InstanceMask {
  int instance = 0;  ///< value in `instance`
  int class_id = 0;  ///< value in `semantic`
  /// Down the columns, from the left one: how many pixels are outside (0 where the first one is inside), how
  /// many inside, outside, and so on, up to the last pixel.
  std::vector<std::uint32_t> runs;
  std::int64_t area_px = 0;
  Eigen::AlignedBox2i box;  ///< from the first to the last column and row, both included
};

/// The masks in two images of one size, sorted by instance, then by class. Pixels whose instance is 0 belong
/// to none.
std::vector<InstanceMask> instance_masks(const OIIO::ImageBuf& instance, const OIIO::ImageBuf& semantic);

/// Runs as COCO compresses them: from the fourth one on as the difference to the run two before, each number
/// in groups of five bits, the lowest first, with its sign as the highest bit of the last group. A group is a
/// character: '0' plus its bits, plus 32 where another one follows.
std::string compressed_runs(std::span<const std::uint32_t> runs);

}  // namespace cps
