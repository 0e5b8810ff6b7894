#pragma once

#include <span>
#include <string>
#include <vector>

#include "distortion/models/lens_model.h"

/// Lenses from the coefficient lists of other programs, in the order of OpenCV's functions. Lists may end in
/// zeros for coefficients that the model does not have. All throw std::runtime_error `<where>: <name>: …` for
/// such a one that is not 0, and for lists too short.
namespace cps {

/// Brown–Conrady: k1 k2 p1 p2 k3, of which `values` may be a prefix.
Distortion brown_conrady_lens(std::span<const double> values, const std::string& where);

/// OpenCV's vector k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y, of which `values` may be a prefix: a
/// rational lens if k4, k5 or k6 is not 0, otherwise Brown–Conrady.
LensModel plane_lens(std::span<const double> values, const std::string& where);

/// OpenCV's fisheye module: k1 k2 k3 k4.
KannalaBrandt kannala_brandt_lens(std::span<const double> values, const std::string& where);

/// OpenCV's omnidir module: ξ, and k1 k2 p1 p2 on its plane.
UnifiedSpherical unified_spherical_lens(double xi, std::span<const double> values, const std::string& where);

/// The coefficients in these orders, as many as the family has there: brown_conrady 5, rational 8,
/// kannala_brandt 4, unified_spherical k1 k2 p1 p2. Empty for eucm and double_sphere.
std::vector<double> opencv_coefficients(const LensModel& lens);

}  // namespace cps
