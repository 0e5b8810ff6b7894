#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/math/color.h"
#include "renderer/math/fast_math.h"

/// GGX microfacets (Walter et al. 2007) with height-correlated Smith masking (Heitz 2014), isotropic.
/// Directions are in the shading frame, z along the normal, and above the surface.
namespace cps {

/// Distribution of normals, 1/sr. Written with the tangential components, which keeps its precision for small
/// `alpha`.
inline float ggx_distribution(const Vec3& h, float alpha) {
  const float alpha2 = alpha * alpha;
  const float t = (h.x() * h.x() + h.y() * h.y()) / alpha2 + h.z() * h.z();
  return 1.0f / (std::numbers::pi_v<float> * alpha2 * t * t);
}

/// √(α² + (1 − α²)cos²): the root in Smith's Λ.
inline float smith_root(float cosine, float alpha) {
  const float alpha2 = alpha * alpha;
  return std::sqrt(alpha2 + (1.0f - alpha2) * cosine * cosine);
}

/// Masking-shadowing over 4 cosines, G₂ / (4 cos_o cos_i) (Heitz 2014, eq. 99; glTF 2.0 appendix B).
inline float smith_visibility(float cos_o, float cos_i, float alpha) {
  return 0.5f / (cos_i * smith_root(cos_o, alpha) + cos_o * smith_root(cos_i, alpha));
}

/// Density per solid angle of the reflection of `wo` about a normal `h` from sample_visible_normal():
/// G₁ D / (4 cos_o).
inline float visible_normal_pdf(const Vec3& wo, const Vec3& h, float alpha) {
  return ggx_distribution(h, alpha) / (2.0f * (wo.z() + smith_root(wo.z(), alpha)));
}

/// A microfacet normal among those visible from `wo` (Heitz 2018; spherical caps of Dupuy & Benyoub 2023).
inline Vec3 sample_visible_normal(const Vec3& wo, float alpha, const Eigen::Vector2f& u) {
  const Vec3 stretched = Vec3(wo.x() * alpha, wo.y() * alpha, wo.z()).normalized();
  const float z = (1.0f - u.y()) * (1.0f + stretched.z()) - stretched.z();
  const float sine = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const SinCos phi = sincos_of_turns(u.x());
  const Vec3 h = Vec3(sine * phi.cos, sine * phi.sin, z) + stretched;
  return Vec3(h.x() * alpha, h.y() * alpha, std::max(h.z(), 1e-7f)).normalized();
}

/// Schlick's (1 − cos)⁵ (1994).
inline float schlick_weight(float cosine) {
  const float m = std::clamp(1.0f - cosine, 0.0f, 1.0f);
  const float m2 = m * m;
  return m2 * m2 * m;
}

}  // namespace cps
