#include "sampler/lens_options.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace cps {
namespace {

constexpr std::array words = {std::pair(LensScheme::sequential, "sequential"),
                              std::pair(LensScheme::shape_prior, "shape_prior"),
                              std::pair(LensScheme::real_lenses, "real_lenses")};

}  // namespace

std::string to_string(LensScheme scheme) {
  for (const auto& [known, word] : words)
    if (known == scheme) return word;
  return "";
}

LensScheme lens_scheme_from_string(const std::string& word) {
  std::string list;
  for (const auto& [scheme, known] : words) {
    if (known == word) return scheme;
    if (!list.empty()) list += ", ";
    list += known;
  }
  throw std::runtime_error("is not one of " + list);
}

bool LensOptions::is_valid(std::string* why) const {
  if (!(sequential_share >= 0 && sequential_share <= 1)) {
    *why = "sequential_share: must lie in [0, 1]";
    return false;
  }
  return bounds.is_valid(why) && principal_point.is_valid(why);
}

}  // namespace cps
