#pragma once

#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "distortion/crop/limits.h"

namespace cps {

/// How the five coefficients of a lens are drawn; see docs/lenses.md.
enum class LensScheme {
  sequential,   ///< one after another, each uniform in the interval that the others leave it
  shape_prior,  ///< corner displacement and shape, chosen to cover what cameras have
  real_lenses,  ///< corner displacement and shape as photographic lenses of that H-FOV have them
};

std::string to_string(LensScheme scheme);
/// Throws std::runtime_error, naming the words there are, on any other.
LensScheme lens_scheme_from_string(const std::string& word);

std::string to_string(Coefficient which);
/// Throws std::runtime_error, naming those there are, on any other.
Coefficient coefficient_from_string(const std::string& word);

/// Which coefficients the sequential scheme draws, and between what, beyond what LensBounds say.
struct CoefficientChoice {
  std::vector<Coefficient> drawn{std::begin(all_coefficients), std::end(all_coefficients)};  ///< others are 0
  double k1_min = -std::numeric_limits<double>::infinity();  ///< as in a label: on the plane z = 1
  double k1_max = std::numeric_limits<double>::infinity();
  bool has_k1_range() const;
  bool is_all() const;  ///< nothing is left out or limited
};

/// How lenses are drawn, and which.
struct LensOptions {
  LensScheme scheme = LensScheme::sequential;
  /// Share of the lenses that the sequential scheme draws where another is chosen, for coverage.
  double sequential_share = 0.2;
  CoefficientChoice coefficients;
  LensBounds bounds;
  PrincipalPointBounds principal_point;
  bool is_valid(std::string* why) const;
};

}  // namespace cps
