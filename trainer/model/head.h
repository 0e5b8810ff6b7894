#pragma once

#include <string>

namespace cps {

/// What a network says of an image: which lens family, in which form.
enum class Head {
  brown_conrady,             ///< eight standardised outputs (calibration/targets.h)
  deepcalib_regression,      ///< focal length and ξ of a unified spherical lens, one sigmoid each
  deepcalib_classification,  ///< the same, as one distribution over bins each (Bogdan et al. 2018)
};

std::string to_string(Head head);
/// Throws std::runtime_error on any other word.
Head head_from_string(const std::string& word);

/// Outputs of the network's last layer.
int unit_count(Head head);

/// Whether the network says a unified spherical lens (trainer/deepcalib).
inline bool is_deepcalib(Head head) {
  return head != Head::brown_conrady;
}

}  // namespace cps
