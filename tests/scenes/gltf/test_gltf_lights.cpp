#include <catch2/catch.hpp>
#include <cmath>

#include "tests/scenes/gltf/gltf_maker.h"

using cps::PunctualLight;
using nlohmann::json;

namespace {

GltfMaker lit_triangle(const json& light) {
  GltfMaker maker = one_triangle();
  maker.json["extensionsUsed"] = {"KHR_lights_punctual"};
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
  maker.json["nodes"].push_back({{"translation", {1, 2, 3}},
                                 {"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},  // −z becomes +y
                                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  maker.json["scenes"][0]["nodes"] = {0, 1};
  return maker;
}

}  // namespace

TEST_CASE("lights take position and direction from their nodes and intensity in kcd and klx") {
  std::vector<std::string> warnings;
  const cps::Scene scene =
      import_glb(lit_triangle({{"type", "spot"},
                               {"name", "lantern"},
                               {"color", {1, 0.5, 0.25}},
                               {"intensity", 800},
                               {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.6}}}}),
                 &warnings);
  CHECK(warnings.empty());
  REQUIRE(scene.lights.size() == 1);
  const PunctualLight& light = scene.lights[0];
  CHECK(light.name == "lantern");
  CHECK(light.kind == PunctualLight::Kind::spot);
  CHECK(light.position == Eigen::Vector3f(1, 2, 3));
  CHECK((light.direction - Eigen::Vector3f(0, 1, 0)).norm() < 1e-6f);
  CHECK((light.intensity - Eigen::Vector3f(0.8f, 0.4f, 0.2f)).norm() < 1e-6f);
  CHECK(light.cos_inner == Approx(std::cos(0.3)));
  CHECK(light.cos_outer == Approx(std::cos(0.6)));
}

TEST_CASE("a light's defaults are white and one candela or lux") {
  for (const char* type : {"point", "directional"}) {
    const PunctualLight light = import_glb(lit_triangle({{"type", type}})).lights.at(0);
    CHECK(light.intensity == Eigen::Vector3f::Constant(0.001f));
    CHECK((light.kind == PunctualLight::Kind::directional) == (type[0] == 'd'));
  }
  const PunctualLight spot =
      import_glb(lit_triangle({{"type", "spot"}, {"spot", json::object()}})).lights.at(0);
  CHECK(spot.cos_inner == 1);
  CHECK(spot.cos_outer == Approx(std::cos(std::acos(-1.0) / 4)));
}

TEST_CASE("invalid lights are refused by name") {
  const std::string where = "KHR_lights_punctual.lights[0]";
  CHECK(refusal(lit_triangle({{"type", "area"}})) ==
        where + ".type: \"area\" is not point, spot or directional");
  CHECK(refusal(lit_triangle({{"type", "point"}, {"intensity", -1}})) ==
        where + ".intensity: must be a number of at least 0");
  CHECK(refusal(lit_triangle({{"type", "point"}, {"color", {1, 2}}})) ==
        where + ".color: must be 3 numbers of at least 0");
  CHECK(refusal(lit_triangle({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.9}}}})) ==
        where + ".spot: needs 0 <= innerConeAngle < outerConeAngle <= pi/2");
  CHECK(refusal(lit_triangle({{"type", "point"}, {"intensity", "strong"}})) ==
        "extensions.KHR_lights_punctual.lights[0].intensity: does not fit glTF's schema, where "
        "extensions.KHR_lights_punctual.lights[].intensity is a number");
  GltfMaker maker = lit_triangle({{"type", "point"}});
  maker.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 3;
  CHECK(refusal(maker) == "nodes[1].KHR_lights_punctual.light: 3 does not exist");
}
