#pragma once

#include <string>

namespace cps {

/// What a network says of an image: which lens family, in which form.
enum class Head {
  brown_conrady,  ///< eight standardised outputs (calibration/targets.h)
  /// The same with their variances, and weights of the picture's edges: a fit joins both (trainer/fit).
  brown_conrady_fit,
  deepcalib_regression,      ///< focal length and ξ of a unified spherical lens, one sigmoid each
  deepcalib_classification,  ///< the same, as one distribution over bins each (Bogdan et al. 2018)
};

std::string to_string(Head head);
/// Throws std::runtime_error on any other word.
Head head_from_string(const std::string& word);

/// Outputs of the network's last layer.
int unit_count(Head head);

/// Numbers that the head makes of an image: the last layer's outputs or, with a fit, the eight standardised
/// outputs and their covariance, row by row.
int row_width(Head head);

/// Whether the network says a unified spherical lens (trainer/deepcalib).
inline bool is_deepcalib(Head head) {
  return head == Head::deepcalib_regression || head == Head::deepcalib_classification;
}

/// Whether a fit to the picture's edges makes the outputs.
inline bool is_fit(Head head) {
  return head == Head::brown_conrady_fit;
}

}  // namespace cps
