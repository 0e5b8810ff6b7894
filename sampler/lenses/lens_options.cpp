#include "sampler/lenses/lens_options.h"

#include <array>
#include <set>
#include <stdexcept>
#include <utility>

namespace cps {
namespace {

constexpr std::array words = {std::pair(LensScheme::sequential, "sequential"),
                              std::pair(LensScheme::shape_prior, "shape_prior"),
                              std::pair(LensScheme::real_lenses, "real_lenses")};

constexpr std::array coefficient_words = {std::pair(Coefficient::k1, "k1"), std::pair(Coefficient::k2, "k2"),
                                          std::pair(Coefficient::k3, "k3"), std::pair(Coefficient::p1, "p1"),
                                          std::pair(Coefficient::p2, "p2")};

}  // namespace

std::string to_string(Coefficient which) {
  return coefficient_words[static_cast<int>(which)].second;
}

Coefficient coefficient_from_string(const std::string& word) {
  for (const auto& [which, known] : coefficient_words)
    if (word == known) return which;
  throw std::runtime_error("is not made of k1, k2, k3, p1, p2");
}

bool CoefficientChoice::has_k1_range() const {
  return k1_min != CoefficientChoice{}.k1_min || k1_max != CoefficientChoice{}.k1_max;
}

bool CoefficientChoice::is_all() const {
  return !has_k1_range() && std::set(drawn.begin(), drawn.end()).size() == coefficient_words.size();
}

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

std::string LensOptions::fault() const {
  if (!(sequential_share >= 0 && sequential_share <= 1)) return "sequential_share: must lie in [0, 1]";
  if (!(real_lenses_share >= 0 && sequential_share + real_lenses_share <= 1))
    return "sequential_share, real_lenses_share: must lie in [0, 1], and their sum too";
  if (real_lenses_share > 0 && scheme != LensScheme::shape_prior)
    return "real_lenses_share: needs lens_draw = shape_prior";
  if (coefficients.drawn.empty()) return "coefficients: name at least one of k1, k2, k3, p1, p2";
  if (!(coefficients.k1_min <= 0 && coefficients.k1_max >= 0))
    return "k1_min ≤ 0 ≤ k1_max: must hold, as a lens starts without distortion";
  if (!coefficients.is_all() && scheme != LensScheme::sequential)
    return "coefficients, k1_min, k1_max: need lens_draw = sequential; a prior draws all of them together";
  for (const std::string& fault : {bounds.fault(), principal_point.fault()})
    if (!fault.empty()) return fault;
  return "";
}

}  // namespace cps
