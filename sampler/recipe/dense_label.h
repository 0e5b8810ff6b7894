#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace cps {

/// What a dataset can say of every pixel of an image: of the ray through the pixel's centre and the image's
/// lens.
enum class DenseLabel {
  depth,     ///< metres along the optical axis
  distance,  ///< metres along the ray
  normal,    ///< of the surface, with normal maps, towards the camera
  instance,  ///< which object of the scene
  semantic,  ///< what kind of thing
  rays,      ///< unit vector of the ray itself
  up,        ///< direction in the picture that leads upwards in the world
  latitude   ///< of the ray above the horizon
};

inline constexpr std::array<const char*, 8> dense_label_names = {
    "depth", "distance", "normal", "instance", "semantic", "rays", "up", "latitude"};

inline std::string to_string(DenseLabel label) {
  return dense_label_names[static_cast<std::size_t>(label)];
}

/// Throws std::runtime_error naming the labels there are.
inline DenseLabel dense_label_from(const std::string& name) {
  for (std::size_t i = 0; i < dense_label_names.size(); ++i)
    if (name == dense_label_names[i]) return static_cast<DenseLabel>(i);
  throw std::runtime_error("must be of depth, distance, normal, instance, semantic, rays, up, latitude");
}

/// Whether rays are cast for it. The others follow from the camera, its lens and its pose.
constexpr bool needs_scene(DenseLabel label) {
  return label <= DenseLabel::semantic;
}

}  // namespace cps
