#include "trainer/model/head.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "trainer/calibration/targets.h"
#include "trainer/deepcalib/bins.h"

namespace cps {
namespace {

constexpr std::array<std::pair<Head, const char*>, 4> head_names{
    {{Head::brown_conrady, "brown_conrady"},
     {Head::brown_conrady_fit, "brown_conrady_fit"},
     {Head::deepcalib_regression, "deepcalib_regression"},
     {Head::deepcalib_classification, "deepcalib_classification"}}};

}  // namespace

std::string to_string(Head head) {
  for (const auto& [known, name] : head_names)
    if (known == head) return name;
  return {};
}

Head head_from_string(const std::string& word) {
  for (const auto& [known, name] : head_names)
    if (word == name) return known;
  throw std::runtime_error("head '" + word +
                           "': unknown: use brown_conrady, brown_conrady_fit, deepcalib_regression or "
                           "deepcalib_classification");
}

int unit_count(Head head) {
  switch (head) {
    case Head::brown_conrady:
      return output_count;
    case Head::brown_conrady_fit:
      return 2 * output_count;
    case Head::deepcalib_regression:
      return 2;
    case Head::deepcalib_classification:
      return focal_bins + xi_bins;
  }
  return 0;
}

int row_width(Head head) {
  return is_fit(head) ? output_count + output_count * output_count : unit_count(head);
}

}  // namespace cps
