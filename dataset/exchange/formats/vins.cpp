#include <array>

#include "dataset/exchange/formats/formats.h"

/// VINS and camodocal. model_type PINHOLE: projection_parameters fx fy cx cy, distortion_parameters k1 k2 p1
/// p2. KANNALA_BRANDT: projection_parameters k2 k3 k4 k5 (of θ³, θ⁵, θ⁷, θ⁹) mu mv u0 v0. MEI:
/// mirror_parameters xi, distortion_parameters k1 k2 p1 p2, projection_parameters gamma1 gamma2 u0 v0.
namespace cps {
namespace {

/// The object of this key, checked to hold no coefficients but `known`; empty if the key is missing.
nlohmann::json group(const JsonKeys& root, const char* key, std::initializer_list<const char*> known) {
  if (!root.json.contains(key)) return nlohmann::json::object();
  const JsonKeys keys = root.object(key);
  if (!keys.json.is_object()) root.fail(key, "must be keys with a number each");
  named_lens(keys, {NamedLens::plane});
  refuse_other_coefficients(keys, known);
  return keys.json;
}

Pinhole pinhole(const JsonKeys& root, const JsonKeys& projection, std::array<const char*, 4> names) {
  return {.width = root.pixels("image_width"),
          .height = root.pixels("image_height"),
          .fx = projection.number(names[0]),
          .fy = projection.number(names[1]),
          .cx = projection.number(names[2]),
          .cy = projection.number(names[3])};
}

}  // namespace

ModelCamera read_vins(const JsonKeys& root, const std::string& name) {
  using enum NamedLens;
  const NamedLens named = named_lens(root, {plane, kannala_brandt, unified_spherical});
  refuse_other_coefficients(root, {});
  const std::string camera_name = root.json.contains("camera_name") ? name_at(root, "camera_name") : name;
  if (named == kannala_brandt) {
    group(root, "distortion_parameters", {});
    group(root, "mirror_parameters", {});
    const nlohmann::json json =
        group(root, "projection_parameters", {"k2", "k3", "k4", "k5", "mu", "mv", "u0", "v0"});
    const JsonKeys projection{json, root.file};
    return {camera_name, pinhole(root, projection, {"mu", "mv", "u0", "v0"}),
            KannalaBrandt{.k1 = projection.number("k2"),
                          .k2 = projection.number("k3"),
                          .k3 = projection.number("k4"),
                          .k4 = projection.number("k5")}};
  }
  const nlohmann::json lens_json = group(root, "distortion_parameters", {"k1", "k2", "p1", "p2"});
  const JsonKeys lens{lens_json, root.file};
  const auto optional = [&](const char* key) { return lens.json.contains(key) ? lens.number(key) : 0.0; };
  const Distortion distortion{
      .k1 = optional("k1"), .k2 = optional("k2"), .p1 = optional("p1"), .p2 = optional("p2")};
  if (named == unified_spherical) {
    const nlohmann::json mirror = group(root, "mirror_parameters", {"xi"}),
                         json = group(root, "projection_parameters", {"gamma1", "gamma2", "u0", "v0"});
    const JsonKeys projection{json, root.file};
    return {camera_name, pinhole(root, projection, {"gamma1", "gamma2", "u0", "v0"}),
            UnifiedSpherical{.xi = JsonKeys{mirror, root.file}.number("xi"), .distortion = distortion}};
  }
  group(root, "mirror_parameters", {});
  const nlohmann::json json = group(root, "projection_parameters", {});
  const JsonKeys projection{json, root.file};
  return {camera_name, pinhole(root, projection, {"fx", "fy", "cx", "cy"}), distortion};
}

}  // namespace cps
