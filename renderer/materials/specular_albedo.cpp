#include "renderer/materials/specular_albedo.h"

#include <algorithm>
#include <array>

#include "renderer/materials/microfacet.h"
#include "renderer/math/sobol.h"

namespace cps {
namespace {

constexpr int cosines = 64, roughnesses = 64, samples = 256;
constexpr float smallest_cosine = 1e-3f, smallest_alpha = 1e-3f;

struct AlbedoTable {
  std::array<std::array<SpecularAlbedo, cosines>, roughnesses> directional;
  std::array<SpecularAlbedo, roughnesses> mean;
};

/// Quasi-Monte Carlo over the visible normals, whose weight is G₂/G₁ · F.
SpecularAlbedo integrate(float alpha, float cosine) {
  const Vec3 wo(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  double scale = 0, bias = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const Eigen::Vector2f u((static_cast<float>(i) + 0.5f) / samples, unit_float(reverse_bits(i)));
    const Vec3 h = sample_visible_normal(wo, alpha, u);
    const float cos_h = wo.dot(h);
    const float cos_i = 2.0f * cos_h * h.z() - wo.z();
    if (cos_i <= 0.0f) continue;
    const float weight =
        smith_visibility(cosine, cos_i, alpha) * 2.0f * cos_i * (cosine + smith_root(cosine, alpha));
    const float fresnel = schlick_weight(cos_h);
    scale += weight * (1.0f - fresnel);
    bias += weight * fresnel;
  }
  return {static_cast<float>(scale / samples), static_cast<float>(bias / samples)};
}

AlbedoTable make_table() {
  AlbedoTable table;
  for (int r = 0; r < roughnesses; ++r) {
    const float roughness = static_cast<float>(r) / (roughnesses - 1);
    const float alpha = std::max(roughness * roughness, smallest_alpha);
    double scale = 0, bias = 0, weights = 0;
    for (int c = 0; c < cosines; ++c) {
      const float cosine = std::max(static_cast<float>(c) / (cosines - 1), smallest_cosine);
      const SpecularAlbedo albedo = integrate(alpha, cosine);
      table.directional[r][c] = albedo;
      // Trapezoids of ∫ albedo(µ) 2µ dµ.
      const double weight = (c == 0 || c == cosines - 1 ? 0.5 : 1.0) * cosine;
      scale += weight * albedo.scale;
      bias += weight * albedo.bias;
      weights += weight;
    }
    table.mean[r] = {static_cast<float>(scale / weights), static_cast<float>(bias / weights)};
  }
  return table;
}

const AlbedoTable& table() {
  static const AlbedoTable instance = make_table();
  return instance;
}

SpecularAlbedo mix(const SpecularAlbedo& a, const SpecularAlbedo& b, float t) {
  return {a.scale + t * (b.scale - a.scale), a.bias + t * (b.bias - a.bias)};
}

struct Cell {
  int index;
  float fraction;
};

Cell cell_of(float value, int count) {
  const float position = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(count - 1);
  const int index = std::min(static_cast<int>(position), count - 2);
  return {index, position - static_cast<float>(index)};
}

}  // namespace

SpecularAlbedo specular_albedo(float roughness, float cosine) {
  const auto& rows = table().directional;
  const Cell r = cell_of(roughness, roughnesses), c = cell_of(cosine, cosines);
  return mix(mix(rows[r.index][c.index], rows[r.index][c.index + 1], c.fraction),
             mix(rows[r.index + 1][c.index], rows[r.index + 1][c.index + 1], c.fraction), r.fraction);
}

SpecularAlbedo mean_specular_albedo(float roughness) {
  const Cell r = cell_of(roughness, roughnesses);
  return mix(table().mean[r.index], table().mean[r.index + 1], r.fraction);
}

}  // namespace cps
