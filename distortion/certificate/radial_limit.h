#pragma once

#include "distortion/brown_conrady.h"

namespace cps {

/// The radius on the plane z = 1 up to which the distorted radius grows with the ideal one: √ of the smallest
/// positive root of 1 + 3 k1 s + 5 k2 s² + 7 k3 s³, in closed form (Leotta, Russell, Matrai 2022); infinite
/// if there is none. It ignores p1 and p2, so it describes a lens and proves nothing; certify() proves.
double radial_limit(const Distortion& lens);

}  // namespace cps
