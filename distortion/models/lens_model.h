#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "distortion/brown_conrady.h"
#include "distortion/models/double_sphere.h"
#include "distortion/models/eucm.h"
#include "distortion/models/kannala_brandt.h"
#include "distortion/models/rational.h"
#include "distortion/models/unified_spherical.h"

/// Lens families. A file per family defines its numbers and where they send rays (projection.h); certificate/
/// proves them one-to-one, inverse/ inverts them, conversion/ fits one by another, warp/ makes pictures. To
/// add a family: (1) its struct and projection in a file of its own, and its place in LensModel; (2) its name
/// and parameters in lens_model.cpp; (3) its angle limit in projection.cpp; (4) its certificate and inverse
/// in certificate/radial_certificate.cpp and inverse/region_inverse.h.
namespace cps {

using LensModel = std::variant<Distortion, RationalLens, KannalaBrandt, UnifiedSpherical, Eucm, DoubleSphere>;

/// The name of a lens' family in files and options: brown_conrady, rational, kannala_brandt,
/// unified_spherical, eucm or double_sphere.
std::string_view family_name(const LensModel& lens);

/// All family names, in the order of LensModel.
std::vector<std::string_view> family_names();

/// The lens' parameters by name, in the order of its struct (unified_spherical: xi, k1, k2, k3, p1, p2).
std::vector<std::pair<std::string_view, double>> parameters(const LensModel& lens);

/// The lens of a family with these parameters; those not named keep the family's defaults. Throws
/// std::runtime_error in one line for an unknown family, an unknown parameter, a number that is not finite or
/// one outside the family's range; the line names the parameter and the known ones.
LensModel lens_from_parameters(std::string_view family, const std::map<std::string, double>& parameters);

/// Empty if the parameters are finite and within the family's range; otherwise one line that names the
/// parameter and the range.
std::string fault(const LensModel& lens);

/// "kannala_brandt, k1 -0.02, k2 0.001, …" with six digits.
std::string description(const LensModel& lens);

}  // namespace cps
