#include "renderer/materials/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/materials/microfacet.h"
#include "renderer/materials/specular_albedo.h"
#include "renderer/math/fast_math.h"

namespace cps {
namespace {

constexpr float coat_f0 = 0.04f;
constexpr float min_alpha = 1e-3f;  // a mirror: floats resolve nothing sharper
constexpr float inv_pi = std::numbers::inv_pi_v<float>;

float alpha_of(float roughness) {
  return std::max(roughness * roughness, min_alpha);
}

Coat make_coat(const BsdfParameters& p, const Vec3& wo) {
  Coat coat;
  coat.strength = p.clearcoat;
  coat.roughness = p.clearcoat_roughness;
  coat.alpha = alpha_of(coat.roughness);
  coat.frame = frame_around(p.clearcoat_normal);
  coat.wo = coat.frame.to_local(wo);
  coat.wo.z() = std::max(coat.wo.z(), 1e-4f);
  return coat;
}

Vec3 mirrored(const Vec3& wo, const Vec3& h) {
  return 2.0f * wo.dot(h) * h - wo;
}

/// The layer and the base below it.
BsdfValue evaluate_below_coat(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
  if (wi.z() <= 0.0f || wo.z() <= 0.0f) return {Color::Zero(), 0.0f};
  const float base_pdf = bsdf.diffuse_probability * wi.z() * inv_pi;
  if (!bsdf.has_layer) {
    const Color base = bsdf.diffuse * inv_pi * wi.z();
    return bsdf.draws_base ? BsdfValue{base, base_pdf} : BsdfValue{Color::Zero(), 0.0f, base};
  }
  const Vec3 h = (wo + wi).normalized();
  const float schlick = schlick_weight(wo.dot(h));
  const Color fresnel = bsdf.f0 + (bsdf.f90 - bsdf.f0) * schlick;
  const float layer = ggx_distribution(h, bsdf.alpha) * smith_visibility(wo.z(), wi.z(), bsdf.alpha);
  const float base = inv_pi * bsdf.base_share *
                     (1.0f - specular_albedo(bsdf.roughness, wi.z())(bsdf.base_f0, bsdf.base_f90));
  const float layer_pdf = bsdf.specular_probability * visible_normal_pdf(wo, h, bsdf.alpha);
  if (!bsdf.draws_base) return {fresnel * layer * wi.z(), layer_pdf, bsdf.diffuse * base * wi.z()};
  return {(fresnel * layer + bsdf.diffuse * base) * wi.z(), layer_pdf + base_pdf};
}

void add_coat(const Bsdf& bsdf, const Vec3& shading_wi, BsdfValue& value) {
  const Coat& coat = bsdf.coat;
  const Vec3 wi = coat.frame.to_local(shading_wi);
  if (wi.z() <= 0.0f) return;
  const Vec3 h = (coat.wo + wi).normalized();
  const float fresnel = coat_f0 + (1.0f - coat_f0) * schlick_weight(coat.wo.dot(h));
  value.f_cos += coat.strength * fresnel * ggx_distribution(h, coat.alpha) *
                 smith_visibility(coat.wo.z(), wi.z(), coat.alpha) * wi.z();
  const float probability =
      1.0f - bsdf.specular_probability - bsdf.diffuse_probability - bsdf.straight_probability;
  value.pdf += probability * visible_normal_pdf(coat.wo, h, coat.alpha);
}

}  // namespace

Bsdf make_bsdf(const BsdfParameters& p, const Vec3& wo) {
  Bsdf bsdf;
  bsdf.diffuse = p.base_color * ((1.0f - p.metallic) * (1.0f - p.transmission));
  bsdf.f0 = p.dielectric_f0 + p.metallic * (p.base_color - p.dielectric_f0);
  bsdf.f90 = p.dielectric_f90 + p.metallic * (1.0f - p.dielectric_f90);
  bsdf.has_layer = bsdf.f90 > 0.0f || (bsdf.f0 > 0.0f).any();
  bsdf.roughness = p.roughness;
  bsdf.alpha = alpha_of(p.roughness);
  bsdf.base_f0 = p.dielectric_f0.maxCoeff();
  bsdf.base_f90 = p.dielectric_f90;
  bsdf.straight = p.straight;

  const SpecularAlbedo towards_o = bsdf.has_layer ? specular_albedo(p.roughness, wo.z()) : SpecularAlbedo{};
  const float base_transmission = 1.0f - towards_o(bsdf.base_f0, bsdf.base_f90);
  bsdf.base_share =
      bsdf.has_layer
          ? base_transmission / (1.0f - mean_specular_albedo(p.roughness)(bsdf.base_f0, bsdf.base_f90))
          : 1.0f;

  float from_coat = 0.0f;
  if (p.clearcoat > 0.0f) {
    bsdf.coat = make_coat(p, wo);
    from_coat = p.clearcoat * specular_albedo(bsdf.coat.roughness, bsdf.coat.wo.z())(coat_f0, 1.0f);
    bsdf.diffuse *= 1.0f - from_coat;
    bsdf.f0 *= 1.0f - from_coat;
    bsdf.f90 *= 1.0f - from_coat;
  }

  const float from_layer = towards_o(luminance(bsdf.f0), bsdf.f90);
  const float from_base = base_transmission * luminance(bsdf.diffuse);
  const float from_behind = luminance(bsdf.straight);
  const float all = from_layer + from_base + from_behind + from_coat;
  bsdf.specular_probability = all > 0.0f ? from_layer / all : 0.0f;
  bsdf.straight_probability = all > 0.0f ? from_behind / all : 0.0f;
  bsdf.diffuse_probability =
      from_coat > 0.0f ? from_base / all : 1.0f - bsdf.specular_probability - bsdf.straight_probability;
  return bsdf;
}

Color thin_glass_transmittance(const BsdfParameters& p, float cosine) {
  const float layer = specular_albedo(p.roughness, cosine)(p.dielectric_f0.maxCoeff(), p.dielectric_f90);
  const float coat =
      p.clearcoat > 0.0f ? p.clearcoat * specular_albedo(p.clearcoat_roughness, cosine)(coat_f0, 1.0f) : 0.0f;
  return p.base_color * ((1.0f - p.metallic) * p.transmission * (1.0f - layer) * (1.0f - coat));
}

BsdfValue evaluate_bsdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
  BsdfValue value = evaluate_below_coat(bsdf, wo, wi);
  if (bsdf.coat.strength > 0.0f) add_coat(bsdf, wi, value);
  return value;
}

BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3& wo, float u_lobe, const Eigen::Vector2f& u) {
  using Kind = BsdfSample::Kind;
  const float up_to_straight = bsdf.specular_probability + bsdf.straight_probability;
  BsdfSample sample;
  // Tilted microfacets send some light below their own layer. It is lost, even if the other layer, whose
  // normal may differ, could take it: no density includes it.
  bool is_lost = false;
  if (u_lobe < bsdf.specular_probability) {
    sample.kind = Kind::layer;
    sample.wi = mirrored(wo, sample_visible_normal(wo, bsdf.alpha, u));
    is_lost = sample.wi.z() <= 0.0f;
  } else if (u_lobe < up_to_straight) {
    return {-wo, bsdf.straight / bsdf.straight_probability, 0.0f, Kind::straight};
  } else if (bsdf.coat.strength > 0.0f && u_lobe >= up_to_straight + bsdf.diffuse_probability) {
    sample.kind = Kind::coat;
    const Coat& coat = bsdf.coat;
    const Vec3 wi = mirrored(coat.wo, sample_visible_normal(coat.wo, coat.alpha, u));
    sample.wi = coat.frame.to_world(wi);
    is_lost = wi.z() <= 0.0f;
  } else {
    sample.kind = Kind::diffuse;
    is_lost = !bsdf.draws_base;
    sample.wi = sample_cosine_hemisphere(u);
  }
  if (is_lost) return {sample.wi, Color::Zero(), 0.0f, sample.kind};
  const BsdfValue value = evaluate_bsdf(bsdf, wo, sample.wi);
  sample.pdf = value.pdf;
  sample.weight = value.pdf > 0.0f ? Color(value.f_cos / value.pdf) : Color::Zero();
  return sample;
}

void leave_out_base(Bsdf& bsdf, float times) {
  bsdf.draws_base = false;
  const float others = 1.0f - bsdf.diffuse_probability;
  if (!(others > 0.0f)) return;
  const float scale = std::min(times, 1.0f / others);
  bsdf.specular_probability *= scale;
  bsdf.straight_probability *= scale;
  bsdf.diffuse_probability = 1.0f - others * scale;
}

Color base_albedo(const Bsdf& bsdf) {
  if (!bsdf.has_layer) return bsdf.diffuse;
  return bsdf.diffuse * bsdf.base_share *
         (1.0f - mean_specular_albedo(bsdf.roughness)(bsdf.base_f0, bsdf.base_f90));
}

Vec3 sample_cosine_hemisphere(const Eigen::Vector2f& u) {
  const SinCos phi = sincos_of_turns(u.x());
  const float sine = std::sqrt(u.y());
  return {sine * phi.cos, sine * phi.sin, std::sqrt(1.0f - u.y())};
}

}  // namespace cps
