#pragma once

#include <torch/types.h>

#include <span>
#include <vector>

#include "trainer/deepcalib/sphere_target.h"
#include "trainer/model/head.h"

/// What the last layer of a DeepCalib network means, and how wrong it is. The layer itself is linear.
namespace cps {

/// Mean of log cosh(a − b) over all elements: quadratic near 0, linear far off. Computed without overflow.
torch::Tensor log_cosh_loss(const torch::Tensor& a, const torch::Tensor& b);

/// The training loss of a batch. `rows`: [n, unit_count(head)], the last layer's outputs; one target each.
/// deepcalib_regression: log_cosh_loss() of the two sigmoids. deepcalib_classification: the cross entropy of
/// the targets' bins, the mean over the images, of focal length and ξ summed. On the device of `rows`.
torch::Tensor sphere_loss(Head head, const torch::Tensor& rows, std::span<const SphereTarget> targets);

/// The targets that the outputs (any device) mean, computed in double. deepcalib_regression: the sigmoids.
/// deepcalib_classification: the expectations under the two softmax distributions. The original takes the
/// most probable bin; the expectation has no rounding to bins, changes steadily with the image, and is the
/// prediction of the least mean squared error under the distribution: a doubt goes to the baseline's
/// advantage.
std::vector<SphereTarget> sphere_targets(Head head, const torch::Tensor& rows);

}  // namespace cps
