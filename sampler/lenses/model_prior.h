#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "distortion/models/lens_model.h"
#include "random/counter_hash.h"

/// Lenses of the families beyond Brown–Conrady, drawn from modest built-in priors.
namespace cps {

/// The families that draw_model_lens() knows: unified_spherical, kannala_brandt, eucm, double_sphere.
const std::vector<std::string_view>& prior_families();

/// A lens of the family, each parameter uniform in an interval of its own and independent of the others (see
/// the table in model_prior.cpp and docs/lenses.md). The intervals are this project's own choice; they hold
/// typical calibrations and, to the third order of the angle, the classical projections of fisheyes
/// (equidistant, equisolid and stereographic).
/// The lens need not be one-to-one on a given frame: callers certify it and draw again. A pure function of
/// the arguments. Throws std::runtime_error, naming the families, for one without a prior.
LensModel draw_model_lens(std::string_view family, Stream stream);

}  // namespace cps
