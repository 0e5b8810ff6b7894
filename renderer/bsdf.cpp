#include "renderer/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/fast_math.h"
#include "renderer/microfacet.h"
#include "renderer/specular_albedo.h"

namespace cps {
namespace {

constexpr float dielectric_f0 = 0.04f;   // index 1.5 against air
constexpr float smallest_alpha = 1e-3f;  // a mirror, for all that 24-bit floats can tell
constexpr float inv_pi = std::numbers::inv_pi_v<float>;

}  // namespace

Bsdf make_bsdf(const Color& base_color, float metallic, float roughness, float cos_o) {
  Bsdf bsdf;
  bsdf.diffuse = base_color * (1.0f - metallic);
  bsdf.f0 = dielectric_f0 + metallic * (base_color - dielectric_f0);
  bsdf.roughness = roughness;
  bsdf.alpha = std::max(roughness * roughness, smallest_alpha);

  const SpecularAlbedo towards_o = specular_albedo(roughness, cos_o);
  const float base_transmission = 1.0f - towards_o(dielectric_f0);
  bsdf.base_share = base_transmission / (1.0f - mean_specular_albedo(roughness)(dielectric_f0));

  const float from_layer = towards_o(luminance(bsdf.f0));
  const float from_base = base_transmission * luminance(bsdf.diffuse);
  bsdf.specular_probability = from_layer / (from_layer + from_base);
  return bsdf;
}

BsdfValue evaluate_bsdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
  if (wi.z() <= 0.0f || wo.z() <= 0.0f) return {Color::Zero(), 0.0f};
  const Vec3 h = (wo + wi).normalized();
  const float schlick = schlick_weight(wo.dot(h));
  const Color fresnel = bsdf.f0 + (1.0f - bsdf.f0) * schlick;
  const float layer = ggx_distribution(h, bsdf.alpha) * smith_visibility(wo.z(), wi.z(), bsdf.alpha);
  const float base =
      inv_pi * bsdf.base_share * (1.0f - specular_albedo(bsdf.roughness, wi.z())(dielectric_f0));

  const float p = bsdf.specular_probability;
  return {(fresnel * layer + bsdf.diffuse * base) * wi.z(),
          p * visible_normal_pdf(wo, h, bsdf.alpha) + (1.0f - p) * wi.z() * inv_pi};
}

BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3& wo, float u_lobe, const Eigen::Vector2f& u) {
  BsdfSample sample;
  sample.specular = u_lobe < bsdf.specular_probability;
  if (sample.specular) {
    const Vec3 h = sample_visible_normal(wo, bsdf.alpha, u);
    sample.wi = 2.0f * wo.dot(h) * h - wo;
  } else {
    sample.wi = sample_cosine_hemisphere(u);
  }
  const BsdfValue value = evaluate_bsdf(bsdf, wo, sample.wi);
  sample.pdf = value.pdf;
  sample.weight = value.pdf > 0.0f ? Color(value.f_cos / value.pdf) : Color::Zero();
  return sample;
}

Vec3 sample_cosine_hemisphere(const Eigen::Vector2f& u) {
  const SinCos phi = sincos_of_turns(u.x());
  const float sine = std::sqrt(u.y());
  return {sine * phi.cos, sine * phi.sin, std::sqrt(1.0f - u.y())};
}

}  // namespace cps
