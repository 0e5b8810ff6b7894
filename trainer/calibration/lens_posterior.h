#pragma once

#include <Eigen/Core>
#include <span>

#include "trainer/calibration/targets.h"

namespace cps {

using OutputCovariance = Eigen::Matrix<double, output_count, output_count>;

/// The correlation of outputs over a training set, of which there must be at least one: that of K1 and K2,
/// for example, whose bends make up for each other in drawn lenses. A hundredth of the identity is mixed in,
/// so that it has an inverse; outputs that do not vary are correlated with none.
OutputCovariance correlation(std::span<const Outputs> targets);

/// What is known of a camera: a normal distribution of its outputs in some space.
struct LensPosterior {
  Outputs mean{};
  OutputCovariance covariance = OutputCovariance::Zero();

  /// The standard deviation of each output.
  Outputs deviation() const;
};

/// The same in another space, for an image of this size in pixels: the mean converted, the covariance by the
/// conversion's slopes there (central differences over a hundredth of a standard deviation).
LensPosterior convert(const LensPosterior& posterior, TargetSpace from, TargetSpace to, int width,
                      int height);

}  // namespace cps
