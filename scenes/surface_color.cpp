#include "scenes/surface_color.h"

#include <algorithm>
#include <cmath>

#include "numbers/srgb.h"

namespace cps {
namespace {

float decoded(std::uint8_t byte, bool is_srgb) {
  const double value = byte / 255.0;
  return static_cast<float>(is_srgb ? linear_from_srgb(value) : value);
}

Eigen::Vector3f with_texture(const Scene& scene, const Eigen::Vector3f& factor, const TextureSlot& slot) {
  if (slot.texture < 0) return factor;
  return factor.cwiseProduct(mean_color(scene.textures[slot.texture]));
}

/// The three vertices' values, weighted.
template <class Value>
Value at_hit(const std::vector<Value>& values, const Eigen::Vector3i& triangle,
             const Eigen::Vector2f& weights) {
  return (1 - weights.sum()) * values[triangle[0]] + weights[0] * values[triangle[1]] +
         weights[1] * values[triangle[2]];
}

/// As if all textures repeat.
Eigen::Vector3f nearest_texel(const Texture& texture, const Eigen::Vector2f& uv) {
  const auto index = [](float share, int count) {
    return std::clamp(static_cast<int>((share - std::floor(share)) * static_cast<float>(count)), 0,
                      count - 1);
  };
  const std::size_t texel =
      static_cast<std::size_t>(index(uv.y(), texture.height)) * texture.width + index(uv.x(), texture.width);
  const std::uint8_t* rgba = &texture.rgba[4 * texel];
  return {decoded(rgba[0], texture.srgb), decoded(rgba[1], texture.srgb), decoded(rgba[2], texture.srgb)};
}

}  // namespace

Eigen::Vector3f mean_color(const Texture& texture) {
  constexpr std::size_t max_samples = 4096;
  const std::size_t texels = texture.rgba.size() / 4;
  // Odd, so that the samples of a texture whose width is a power of two are not all in a few columns.
  const std::size_t stride = texels / max_samples | 1;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  std::size_t samples = 0;
  for (std::size_t i = 0; i < texels; i += stride, ++samples)
    for (int channel = 0; channel < 3; ++channel)
      sum[channel] += decoded(texture.rgba[4 * i + channel], texture.srgb);
  return samples == 0 ? sum : Eigen::Vector3f(sum / static_cast<float>(samples));
}

Eigen::Vector3f mean_base_color(const Scene& scene, const Material& material) {
  return with_texture(scene, material.base_color.head<3>(), material.base_color_texture);
}

Eigen::Vector3f mean_emission(const Scene& scene, const Material& material) {
  if (material.unlit) return mean_base_color(scene, material);
  return with_texture(scene, material.emissive, material.emissive_texture);
}

Eigen::Vector3f base_color_at(const Scene& scene, const SurfaceHit& hit) {
  const Mesh& mesh = scene.meshes[scene.instances[hit.instance].mesh];
  const Material& material = scene.materials[mesh.material];
  const Eigen::Vector3i& triangle = mesh.triangles[hit.triangle];
  Eigen::Vector3f color = material.base_color.head<3>();
  if (!mesh.colors.empty())
    color = color.cwiseProduct(at_hit(mesh.colors, triangle, hit.barycentric).head<3>());
  const TextureSlot& slot = material.base_color_texture;
  const std::vector<Eigen::Vector2f>& uv = slot.uv_set == 1 ? mesh.uv1 : mesh.uv0;
  if (slot.texture < 0 || uv.empty()) return color;
  return color.cwiseProduct(
      nearest_texel(scene.textures[slot.texture], slot.uv_transform * at_hit(uv, triangle, hit.barycentric)));
}

}  // namespace cps
