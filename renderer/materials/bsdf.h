#pragma once

#include "renderer/math/color.h"
#include "renderer/math/frame.h"

namespace cps {

/// Parameters of a BSDF: glTF 2.0's metallic-roughness surface and the supported extensions.
struct BsdfParameters {
  Color base_color;
  float metallic = 0, roughness = 1;
  Color dielectric_f0 = Color::Constant(0.04f);  ///< reflectance at normal incidence; index 1.5 against air
  float dielectric_f90 = 1;        ///< reflectance at grazing incidence (KHR_materials_specular)
  float transmission = 0;          ///< fraction of the dielectric's base that is clear glass
  Color straight = Color::Zero();  ///< transmittance: of thin_glass_transmittance(), or 0
  float clearcoat = 0, clearcoat_roughness = 0;
  Vec3 clearcoat_normal = Vec3::UnitZ();  ///< in the shading frame
};

/// A clear coat on top: a second layer, of refractive index 1.5, with a normal of its own.
struct Coat {
  float strength = 0;  ///< 0: no coat, and the rest is not set
  float alpha, roughness;
  Frame frame;  ///< around its normal, in the shading frame
  Vec3 wo;      ///< in that frame
};

/// glTF 2.0's metallic-roughness surface (specification, appendix B): a metal and a dielectric mixed by
/// `metallic`, both with one GGX layer. The appendix weighs the diffuse base below the layer by 1 − F(V·H),
/// which at grazing angles reflects up to 1.5 times the light that arrives. Here the base gets the light that
/// the layer does not reflect, averaged over directions (Kelemen & Szirmay-Kalos 2001), which is reciprocal
/// and never gains energy. A clear coat takes its directional albedo from everything below it, as
/// KHR_materials_clearcoat does with its Fresnel term: not reciprocal, but without gain of energy too. Thin
/// glass lets light pass straight on. Directions are in the shading frame and point away from the surface.
struct Bsdf {
  Color diffuse;               ///< base colour of the dielectric part
  Color f0;                    ///< the layer's reflectance at normal incidence
  float f90;                   ///< and at grazing incidence
  bool has_layer;              ///< false where both are 0: a Lambert surface
  float roughness;             ///< glTF's
  float alpha;                 ///< GGX width, roughness²
  float base_f0, base_f90;     ///< of the dielectric part of the layer, which covers the diffuse base
  float base_share;            ///< (1 − E(wo)) / (1 − mean E): the layer's transmission towards wo
  float specular_probability;  ///< of sampling the layer
  float diffuse_probability;
  float straight_probability;
  Color straight;          ///< fraction of light that passes straight through thin glass
  Coat coat;               ///< sampled in all other cases
  bool draws_base = true;  ///< false: sample_bsdf() leaves out the diffuse base, whose light is known
};

/// `wo` points to the viewer, its z > 0.
Bsdf make_bsdf(const BsdfParameters& parameters, const Vec3& wo);

/// Fraction of light that passes straight through, at this cosine to the normal. Shadow rays that cross glass
/// are multiplied by it, and so are paths that go straight on.
Color thin_glass_transmittance(const BsdfParameters& parameters, float cosine);

/// Value times |cos_i|, and the density (1/sr) with which sample_bsdf would choose wi. All are 0 below the
/// surface: light that passes straight through has no density.
struct BsdfValue {
  Color f_cos;  ///< of the lobes that sample_bsdf() draws
  float pdf;
  Color base_f_cos = Color::Zero();  ///< of the diffuse base, if it is not drawn
};
BsdfValue evaluate_bsdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi);

struct BsdfSample {
  enum class Kind { layer, diffuse, coat, straight };
  Vec3 wi;
  Color weight;  ///< f·cos / pdf
  float pdf;     ///< 0: no direction, the path ends. Not set where the light goes straight
  Kind kind;
};
BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3& wo, float u_lobe, const Eigen::Vector2f& u);

/// Leaves the diffuse base out of what sample_bsdf() draws, and draws the others `times` as often, if there
/// is room.
void leave_out_base(Bsdf& bsdf, float times);

/// Share of light that the diffuse base sends towards wo, if the same light comes from everywhere.
Color base_albedo(const Bsdf& bsdf);

/// A direction in the upper hemisphere with density cos/π.
Vec3 sample_cosine_hemisphere(const Eigen::Vector2f& u);

}  // namespace cps
