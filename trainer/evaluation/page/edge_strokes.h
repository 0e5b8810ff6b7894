#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trainer/fit/lens_fit.h"

/// The edges that a fit gets of a picture, as lines to draw. Points are in pixels of the picture from its top
/// left corner, x to the right and y down.
namespace cps {

/// Which way edges of this tilt run (orientation.h): (−tilt, 1) for near-vertical ones, family 0, and
/// (1, −tilt) for near-horizontal ones. Not of unit length.
Eigen::Vector2d edge_direction(int family, double tilt);

/// A straight line between two points.
struct Stroke {
  Eigen::Vector2d from, to;
};

/// The edges of one family in one block.
struct EdgeStroke {
  int family = 0;
  Stroke measured;                 ///< through the block's middle, along its edges' mean tilt
  std::optional<Stroke> modelled;  ///< beside it, along the model's tilt, where it has one
  /// √weight, the inverse of the tilt's standard deviation, over that of the picture's 95 % quantile of
  /// weights; at most 1.
  double opacity = 0;
};

/// The length of a block's shorter side in pixels: strokes are a little shorter.
double block_px(const EdgeBlocks& edges);

/// Strokes of the blocks whose opacity is at least .05, in the order of EdgeBlocks. `model`: of this picture.
std::vector<EdgeStroke> edge_strokes(const FrameEvidence& frame, const TiltModel& model);

}  // namespace cps
