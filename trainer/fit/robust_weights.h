#pragma once

#include <span>
#include <vector>

#include "trainer/fit/lens_fit.h"

/// Weights for what does not fit the rest: moving cars among a street's edges, frames that err.
namespace cps {

/// The factor on the precision of `dimensions` numbers that are `squared_distance` squared standard
/// deviations away from where they should be: (ν + dimensions) / (ν + squared_distance), as of errors with
/// Student's distribution of ν degrees of freedom (Lange, Little, Taylor 1989), but at most 1. What lies as
/// close as normal errors do then keeps what it says of itself, and with it the covariance that is computed
/// from such precisions.
double student_weight(double squared_distance, int dimensions, double degrees_of_freedom);

/// The standard deviation of normal numbers about zero, of which less than half may be anything else: 1.4826
/// times the median of their sizes (Hampel 1974). There must be at least one.
double robust_deviation(std::vector<double> values);

/// How far each block's tilt is from the model's, in the standard deviations that the block's weight states;
/// in the order of EdgeBlocks. NaN for a block without weight, or where the model has no tilt.
std::vector<double> tilt_residuals(const FrameEvidence& frame, const FitVector& parameters);

/// Multiplies each block's precision by the student_weight() of its residual, in units of `deviation`. A
/// block whose residual is NaN stays as it is.
void weigh_down(EdgeBlocks& edges, std::span<const double> residuals, double deviation,
                double degrees_of_freedom);

}  // namespace cps
