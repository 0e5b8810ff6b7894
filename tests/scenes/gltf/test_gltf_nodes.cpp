#include <catch2/catch.hpp>

#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using nlohmann::json;

TEST_CASE("translation, rotation and scale apply as T·R·S down the tree") {
  GltfMaker maker = one_triangle();
  const double half = std::sqrt(0.5);
  maker.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                         {{"rotation", {0, 0, half, half}}, {"scale", {2, 3, 4}}, {"mesh", 0}}};
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.instances.size() == 1);
  // (1,1,1) is scaled to (2,3,4), turned by 90° about z to (−3,2,4), then moved.
  CHECK((scene.instances[0].world_from_mesh * Vector3f(1, 1, 1)).isApprox(Vector3f(7, 2, 4), 1e-5f));
  CHECK(scene.bounds.min().isApprox(Vector3f(7, 0, 0), 1e-5f));
  CHECK(scene.bounds.max().isApprox(Vector3f(10, 2, 0), 1e-5f));
}

TEST_CASE("a matrix is read column by column") {
  GltfMaker maker = one_triangle();
  maker.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
  const auto transform = import_glb(maker).instances.at(0).world_from_mesh;
  CHECK(transform * Vector3f(0, 0, 0) == Vector3f(7, 8, 9));
  CHECK(transform * Vector3f(1, 0, 0) == Vector3f(8, 10, 12));
}

TEST_CASE("one mesh can have many instances, mirrored ones included") {
  GltfMaker maker = one_triangle();
  maker.json["nodes"] = {
      {{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}, {{"mesh", 0}, {"translation", {0, 5, 0}}}};
  maker.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.meshes.size() == 1);
  REQUIRE(scene.instances.size() == 3);
  CHECK(scene.instances[1].world_from_mesh.linear().determinant() == -1);
  CHECK(scene.instances[1].world_from_mesh * Vector3f(1, 2, 3) == Vector3f(-1, 2, 3));
}

TEST_CASE("the scene's nodes are those of the default scene, else the first, else all") {
  GltfMaker maker = one_triangle();
  maker.json["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, 0}}},
                         {{"mesh", 0}, {"translation", {1, 0, 0}}, {"children", {2}}},
                         {{"mesh", 0}, {"translation", {1, 0, 0}}}};
  const auto x_of_instances = [&] {
    std::vector<float> x;
    for (const auto& instance : import_glb(maker).instances)
      x.push_back(instance.world_from_mesh.translation().x());
    return x;
  };
  maker.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  SECTION("the default scene's") {
    maker.json["scene"] = 1;
    CHECK(x_of_instances() == std::vector<float>{1, 2});
  }
  SECTION("the first scene's without a default") {
    maker.json.erase("scene");
    CHECK(x_of_instances() == std::vector<float>{0});
  }
  SECTION("all trees' without scenes") {
    maker.json.erase("scenes");
    maker.json.erase("scene");
    CHECK(x_of_instances() == std::vector<float>{0, 1, 2});
  }
}

TEST_CASE("a chain of 100,000 nodes is imported") {
  GltfMaker maker = one_triangle();
  json nodes;
  for (int i = 0; i < 100000; ++i) nodes.push_back({{"translation", {0.001, 0, 0}}, {"children", {i + 1}}});
  nodes.push_back({{"mesh", 0}});
  maker.json["nodes"] = nodes;
  CHECK(import_glb(maker).instances.at(0).world_from_mesh.translation().x() == Approx(100));
}

TEST_CASE("nodes that form no trees and invalid transforms are refused") {
  GltfMaker maker = one_triangle();
  json& node = maker.json["nodes"][0];
  SECTION("a cycle") {
    node["children"] = {0};
    CHECK(refusal(maker) == "nodes[0]: is reached twice: the nodes must form trees");
  }
  SECTION("two parents") {
    maker.json["nodes"] = {{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    CHECK(refusal(maker) == "nodes[2]: is reached twice: the nodes must form trees");
  }
  SECTION("no such child") {
    node["children"] = {7};
    CHECK(refusal(maker) == "nodes[7]: does not exist");
  }
  SECTION("a short matrix") {
    node["matrix"] = {1, 0, 0};
    CHECK(refusal(maker) == "nodes[0].matrix: must be 16 numbers");
  }
  SECTION("a projective matrix") {
    node["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    CHECK(refusal(maker) == "nodes[0].matrix: its last row must be 0 0 0 1");
  }
  SECTION("no rotation") {
    node["rotation"] = {0, 0, 0, 0};
    CHECK(refusal(maker) == "nodes[0].rotation: is not a rotation (its length is 0)");
  }
  SECTION("too large") {
    node["scale"] = {1e300, 1e300, 1e300};
    node["children"] = {1};
    maker.json["nodes"].push_back({{"mesh", 0}, {"scale", {1e300, 1, 1}}});
    CHECK(refusal(maker) == "scene: holds no triangles to draw");
  }
  SECTION("too far away") {
    node["translation"] = {1e9, 0, 0};
    CHECK(refusal(maker) == "scene: reaches beyond 10,000 km: scale it to metres");
  }
}
