#pragma once

#include <optional>
#include <string_view>

#include "distortion/models/conversion/convert_fit.h"
#include "distortion/models/conversion/convert_start.h"

namespace cps {

/// The camera of `family`, with the `held` parameters, whose squared error on the rays is smallest; which of
/// its numbers are free is as convert() says. Empty if no lens of the family shows all of the rays.
///
/// A family's shape parameter and the others nearly stand in for each other, so that a fit of all at once
/// creeps along a curved valley, and there may be several minima. The error that the best others leave is
/// therefore first taken along the list of shapes, then minimised about each of its minima (Brent 1973).
std::optional<ModelCamera> best_fit(const ModelCamera& camera, std::string_view family, const SeenRays& seen,
                                    const HeldParameters& held);

}  // namespace cps
