#pragma once

#include "renderer/color.h"

namespace cps {

/// glTF 2.0's metallic-roughness surface (specification, appendix B): a metal and a dielectric of index 1.5
/// mixed by `metallic`, both with one GGX layer. The appendix weighs the diffuse base below the layer by 1 −
/// F(V·H), which reflects up to 1.5 times what arrives at grazing angles; here the base gets what the layer
/// leaves over on average over its directions (Kelemen & Szirmay-Kalos 2001), which is reciprocal and never
/// gains energy. Directions are in the shading frame and point away from the surface.
struct Bsdf {
  Color diffuse;               ///< base colour of the dielectric part
  Color f0;                    ///< reflectance at normal incidence
  float roughness;             ///< glTF's
  float alpha;                 ///< GGX width, roughness²
  float base_share;            ///< (1 − E(wo)) / (1 − mean E): the layer's transmission towards wo
  float specular_probability;  ///< of sampling the layer
};

/// `cos_o` is the cosine between the viewer and the shading normal, > 0.
Bsdf make_bsdf(const Color& base_color, float metallic, float roughness, float cos_o);

/// Value times |cos_i|, and the density (1/sr) with which sample_bsdf would choose wi. Both 0 below the
/// surface.
struct BsdfValue {
  Color f_cos;
  float pdf;
};
BsdfValue evaluate_bsdf(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi);

struct BsdfSample {
  Vec3 wi;
  Color weight;   ///< f·cos / pdf
  float pdf;      ///< 0: no direction, the path ends
  bool specular;  ///< from the layer
};
BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3& wo, float u_lobe, const Eigen::Vector2f& u);

/// Directions by cosine over the upper hemisphere.
Vec3 sample_cosine_hemisphere(const Eigen::Vector2f& u);

}  // namespace cps
