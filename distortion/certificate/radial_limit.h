#pragma once

#include "distortion/brown_conrady.h"

namespace cps {

/// The radius on the plane z = 1 up to which the radial part of the lens grows: √ of the smallest positive
/// root of 1 + 3 k1 s + 5 k2 s² + 7 k3 s³, in closed form (Leotta, Russell, Matrai 2022); infinite when there
/// is none. p1 and p2 play no part in it, so it is a description, not a proof: certify() is the proof.
double radial_limit(const Distortion& lens);

}  // namespace cps
