#include "scenes/mean_color.h"

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

}  // namespace cps
