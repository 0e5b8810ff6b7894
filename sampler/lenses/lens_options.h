#pragma once

#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "distortion/crop/limits.h"

namespace cps {

/// Schemes to draw the five coefficients of a lens; see docs/lenses.md.
enum class LensScheme {
  sequential,   ///< one after another, each uniform in the interval that the others leave it
  shape_prior,  ///< displacement of the corner and shape of the radial curve, covering real cameras
  real_lenses,  ///< the same, distributed as measured on photographic lenses of the H-FOV
};

std::string to_string(LensScheme scheme);
/// Reads what to_string() writes. Throws std::runtime_error, naming the schemes, on any other word.
LensScheme lens_scheme_from_string(const std::string& word);

std::string to_string(Coefficient which);
/// Reads what to_string() writes. Throws std::runtime_error, naming the coefficients, on any other word.
Coefficient coefficient_from_string(const std::string& word);

/// Which coefficients the sequential scheme draws, and limits of k1 in addition to LensBounds.
struct CoefficientChoice {
  std::vector<Coefficient> drawn{std::begin(all_coefficients), std::end(all_coefficients)};  ///< others are 0
  double k1_min = -std::numeric_limits<double>::infinity();  ///< as in a label: on the plane z = 1
  double k1_max = std::numeric_limits<double>::infinity();
  bool has_k1_range() const;
  bool is_all() const;  ///< whether no coefficient is left out or limited
};

/// How lenses are drawn, and the bounds that they keep.
struct LensOptions {
  LensScheme scheme = LensScheme::sequential;
  /// Share of the lenses that are drawn by the sequential scheme although another is chosen, for coverage.
  double sequential_share = 0.2;
  /// Share of the lenses that are drawn by the scheme real_lenses although shape_prior is chosen, so that
  /// both priors are in one dataset.
  double real_lenses_share = 0;
  CoefficientChoice coefficients;
  LensBounds bounds;
  PrincipalPointBounds principal_point;
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

}  // namespace cps
