#include "trainer/images/orientation/orientation.h"

namespace cps {
namespace {

std::array<std::string, orientation_number_count> number_names() {
  static constexpr std::array families{"vertical", "horizontal"};
  static constexpr std::array<const char*, tilt_terms> terms{"1", "x", "y", "xy", "xx", "yy"};
  std::array<std::string, orientation_number_count> names;
  int i = 0;
  for (const std::string family : families) {
    for (const char* term : terms) names[i++] = family + "_tilt_" + term;
    for (const char* term : terms) names[i++] = family + "_error_" + term;
    names[i++] = family + "_share";
    names[i++] = family + "_residual";
  }
  return names;
}

}  // namespace

const std::array<std::string, orientation_number_count> orientation_number_names = number_names();

std::string OrientationOptions::fault() const {
  return max_width >= 32 && max_width <= 65535 ? "" : "orientation-width: must lie in [32, 65535]";
}

OrientationNumbers mirrored(const OrientationNumbers& numbers) {
  // With x also the tilt changes its sign, so terms that are even in x change theirs.
  static constexpr std::array<float, tilt_terms> signs{-1, 1, -1, 1, -1, -1};
  OrientationNumbers result = numbers;
  for (int family = 0; family < edge_families; ++family)
    for (int i = 0; i < tilt_terms; ++i) result[family * numbers_per_family + i] *= signs[i];
  return result;
}

}  // namespace cps
