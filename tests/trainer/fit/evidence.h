#pragma once

#include "random/counter_hash.h"
#include "trainer/fit/lens_fit.h"

/// Pictures whose camera is known, as a fit gets them: made by the model itself.
namespace cps {

/// A wide prior for pictures of this size: 75° seen, K1 −.1, principal point in the middle, and deviations of
/// the size that drawn lenses have.
LensPrior wide_prior(const ImageSize& picture);

/// Parameters drawn from the prior, whose numbers must be independent, of a lens that does not fold in the frame.
FitVector drawn(const LensPrior& prior, Stream stream);

/// Evidence with this prior whose tilts are those of `truth` with normal errors of variance 1 / weight;
/// blocks without a tilt have no weight. Weights are `weight` times a uniform number, and 0 for half of the
/// blocks.
FrameEvidence synthetic_evidence(const LensPrior& prior, const FitVector& truth, const ImageSize& picture,
                                 double weight, Stream stream);

}  // namespace cps
