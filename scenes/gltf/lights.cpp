#include "scenes/gltf/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps::gltf {
namespace {

PunctualLight::Kind kind_of(const Document& document, const std::string& type, const std::string& where) {
  if (type == "point") return PunctualLight::Kind::point;
  if (type == "spot") return PunctualLight::Kind::spot;
  if (type == "directional") return PunctualLight::Kind::directional;
  refuse(document, where + ".type", "\"" + type + "\" is not point, spot or directional");
}

/// The file's light of that index, not yet placed.
PunctualLight make_light(const Document& document, int index) {
  const std::string where = element("KHR_lights_punctual.lights", index);
  const tinygltf::Light& from = document.model.lights[index];
  PunctualLight light;
  light.name = from.name;
  light.kind = kind_of(document, from.type, where);
  if (!(from.intensity >= 0 && from.intensity < 1e12))
    refuse(document, where + ".intensity", "must be a number of at least 0");
  for (std::size_t c = 0; c < 3; ++c) {
    const double color = from.color.empty() ? 1 : from.color.size() == 3 ? from.color[c] : -1;
    if (!(color >= 0 && color < 1e6)) refuse(document, where + ".color", "must be 3 numbers of at least 0");
    light.intensity[static_cast<int>(c)] = static_cast<float>(color * from.intensity / 1000);
  }
  if (light.kind == PunctualLight::Kind::spot) {
    const double inner = from.spot.innerConeAngle, outer = from.spot.outerConeAngle;
    if (!(inner >= 0 && inner < outer && outer <= std::numbers::pi / 2 + 1e-6))
      refuse(document, where + ".spot", "needs 0 <= innerConeAngle < outerConeAngle <= pi/2");
    light.cos_inner = static_cast<float>(std::cos(inner));
    light.cos_outer = static_cast<float>(std::max(0.0, std::cos(outer)));
  }
  return light;
}

}  // namespace

void add_lights(Document& document, std::span<const PlacedNode> placed, Scene& scene) {
  for (const PlacedNode& place : placed) {
    const tinygltf::ExtensionMap& extensions = document.model.nodes[place.node].extensions;
    const auto extension = extensions.find("KHR_lights_punctual");
    if (extension == extensions.end() || !place.is_visible) continue;
    const std::string where = element("nodes", place.node) + ".KHR_lights_punctual.light";
    const bool is_index = extension->second.Has("light") && extension->second.Get("light").IsInt();
    const int index = is_index ? extension->second.Get("light").GetNumberAsInt() : -1;
    if (!in_range(index, document.model.lights))
      refuse(document, where, std::to_string(index) + " does not exist");
    PunctualLight light = make_light(document, index);
    light.position = place.world_from_node.translation().cast<float>();
    const Eigen::Vector3d direction = place.world_from_node.linear() * Eigen::Vector3d(0, 0, -1);
    if (!(direction.norm() > 0) || !light.position.allFinite()) {
      warn(document, where + ": its node's scale is 0 or its position not finite, left out");
      continue;
    }
    light.direction = direction.normalized().cast<float>();
    scene.lights.push_back(std::move(light));
  }
}

}  // namespace cps::gltf
