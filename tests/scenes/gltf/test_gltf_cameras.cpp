#include <catch2/catch.hpp>
#include <cmath>

#include "tests/scenes/gltf/gltf_maker.h"

using nlohmann::json;

namespace {

GltfMaker with_camera(json node) {
  GltfMaker maker = one_triangle();
  maker.json["cameras"] = {
      {{"type", "perspective"}, {"name", "front"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
  maker.json["nodes"].push_back(node);
  maker.json["scenes"][0]["nodes"].push_back(maker.json["nodes"].size() - 1);
  return maker;
}

}  // namespace

TEST_CASE("a camera looks along its node's -z with y up, scaled or not") {
  // A quarter turn about y sends −z to −x.
  const double h = std::sqrt(0.5);
  const cps::Scene scene = import_glb(with_camera(
      {{"camera", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, h, 0, h}}, {"scale", {2, 3, 4}}}));
  REQUIRE(scene.cameras.size() == 1);
  const cps::SceneCamera& camera = scene.cameras[0];
  CHECK(camera.name == "front");
  CHECK(camera.vfov_rad == Approx(0.7));
  const Eigen::Matrix4d world = camera.world_from_camera.matrix();
  CHECK(world.col(3).head<3>().isApprox(Eigen::Vector3d(1, 2, 3)));
  CHECK(world.col(0).head<3>().isApprox(Eigen::Vector3d(0, 0, -1), 1e-6));  // right
  CHECK(world.col(1).head<3>().isApprox(Eigen::Vector3d(0, -1, 0), 1e-6));  // down
  CHECK(world.col(2).head<3>().isApprox(Eigen::Vector3d(-1, 0, 0), 1e-6));  // forward
}

TEST_CASE("orthographic cameras are skipped with a warning, broken cameras are refused") {
  std::vector<std::string> warnings;
  CHECK(import_glb(with_camera({{"camera", 1}}), &warnings).cameras.empty());
  CHECK(warnings == std::vector<std::string>{"orthographic cameras are not read"});

  CHECK(refusal(with_camera({{"camera", 7}})) == "nodes[1].camera: 7 does not exist");
  CHECK(refusal(with_camera({{"camera", 0}, {"scale", {1, 1, 0}}})) ==
        "nodes[1]: its transform scales the camera's axes to 0");
  GltfMaker maker = with_camera({{"camera", 0}});
  maker.json["cameras"][0]["perspective"]["yfov"] = 4;
  CHECK(refusal(maker) == "cameras[0].perspective.yfov: must lie between 0 and pi radians");
}
