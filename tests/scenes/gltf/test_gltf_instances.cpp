#include <catch2/catch.hpp>

#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using nlohmann::json;

TEST_CASE("EXT_mesh_gpu_instancing repeats a mesh in its node's frame") {
  GltfMaker maker = one_triangle();
  maker.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const float half = std::sqrt(0.5f);
  const int translations = maker.add_floats({1, 0, 0, 2, 0, 0}, "VEC3");
  const int rotations = maker.add_floats({0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  const int scales = maker.add_floats({1, 1, 1, 3, 1, 1}, "VEC3");
  json& node = maker.json["nodes"][0];
  node["translation"] = {0, 0, 10};
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}};
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.meshes.size() == 1);
  REQUIRE(scene.instances.size() == 2);
  CHECK(scene.instances[0].world_from_mesh * Vector3f(1, 0, 0) == Vector3f(2, 0, 10));
  // Scaled to (3,0,0), turned to (0,3,0), moved.
  CHECK((scene.instances[1].world_from_mesh * Vector3f(1, 0, 0)).isApprox(Vector3f(2, 3, 10)));

  const std::string where = "nodes[0].EXT_mesh_gpu_instancing";
  json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["SCALE"] = maker.add_floats({1, 1, 1}, "VEC3");
  CHECK(refusal(maker) == where + ": its attributes differ in count");
  attributes["SCALE"] = 99;
  CHECK(refusal(maker) == where + ".SCALE: accessor 99 does not exist");
  node["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", {{"_ID", 0}}}};
  CHECK(refusal(maker) == where + ": its attributes differ in count");
}

TEST_CASE("what a node places is one object, whatever it is made of") {
  GltfMaker maker = one_triangle();
  maker.json["asset"]["generator"] = "a modeller";
  json& primitives = maker.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);  // a thing of two parts
  const int translations = maker.add_floats({0, 0, 0, 5, 0, 0}, "VEC3");
  maker.json["nodes"] = {
      {{"mesh", 0}, {"name", "car"}},
      {{"mesh", 0}},  // without a name
      {{"mesh", 0},
       {"name", "tree"},
       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}}}},
      {{"mesh", 0}, {"name", "invisible"}, {"scale", {0, 0, 0}}},
      {{"mesh", 0}, {"name", "flat"}, {"scale", {1, 1, 0}}},
      {{"name", "empty"}},
      {{"mesh", 0}, {"name", "car"}}};
  maker.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4, 5, 6};
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.generator == "a modeller");
  CHECK(scene.objects == std::vector<std::string>{"car", "", "tree", "tree", "flat", "car"});
  REQUIRE(scene.instances.size() == 12);
  for (int i = 0; i < 12; ++i) CHECK(scene.instances[i].object == i / 2);
  CHECK((scene.instances[6].world_from_mesh * Vector3f(0, 0, 0)).x() == 5);  // the second tree
}

TEST_CASE("a skinned mesh is one object") {
  GltfMaker maker = skinned_triangle();
  maker.json["nodes"][0]["name"] = "walker";
  json& primitives = maker.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.objects == std::vector<std::string>{"walker"});
  REQUIRE(scene.instances.size() == 2);
  CHECK(scene.instances[1].object == 0);
  CHECK(scene.generator.empty());
}

TEST_CASE("a skin takes the rest pose: weights blend the joints' transforms") {
  const cps::Scene scene = import_glb(skinned_triangle());
  REQUIRE(scene.instances.size() == 1);
  CHECK(scene.instances[0].world_from_mesh.isApprox(Eigen::Affine3f::Identity()));
  const std::vector<Vector3f>& positions = scene.meshes[0].positions;
  CHECK(positions[0].isApprox(Vector3f(6, 0, 0)));         // (0,0,0), first joint
  CHECK(positions[1].isApprox(Vector3f(0, 1, 0), 1e-5f));  // (1,0,0), second joint
  // (0,1,0): half of (6,1,0), half of (−1,0,0).
  CHECK(positions[2].isApprox(Vector3f(2.5f, 0.5f, 0), 1e-5f));
}

TEST_CASE("front faces stay front faces under joints that mirror") {
  GltfMaker maker = skinned_triangle();
  maker.json["nodes"][1] = {{"scale", {-1, 1, 1}}};
  maker.json["nodes"][2] = {{"scale", {-1, 1, 1}}};
  maker.primitive()["attributes"]["NORMAL"] = maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  const Vector3f a = mesh.positions[mesh.triangles[0][0]];
  const Vector3f geometric =
      (mesh.positions[mesh.triangles[0][1]] - a).cross(mesh.positions[mesh.triangles[0][2]] - a);
  CHECK(geometric.z() > 0);
  CHECK(mesh.normals[0].isApprox(Vector3f(0, 0, 1)));
}

TEST_CASE("inconsistent skins are refused by name") {
  GltfMaker maker = skinned_triangle();
  SECTION("a joint outside the scene") {
    maker.json["scenes"][0]["nodes"] = {0, 1};
    CHECK(refusal(maker) == "skins[0].joints: must be nodes of the scene");
  }
  SECTION("too few matrices") {
    maker.json["skins"][0]["joints"] = {1, 2, 1};
    CHECK(refusal(maker) == "skins[0].inverseBindMatrices: must be one MAT4 of floats for each joint");
  }
  SECTION("a joint number beyond the skin's") {
    maker.primitive()["attributes"]["JOINTS_0"] =
        maker.add(std::vector<std::uint8_t>(12, 2), 5121, "VEC4", 3);
    CHECK(refusal(maker) ==
          "meshes[0].primitives[0].JOINTS_0: vertex 0 has no joint of its skin or a weight below 0");
  }
  SECTION("no such skin") {
    maker.json["nodes"][0]["skin"] = 1;
    CHECK(refusal(maker) == "skins[1]: does not exist");
  }
  SECTION("no weights") {
    maker.primitive()["attributes"].erase("WEIGHTS_0");
    std::vector<std::string> warnings;
    CHECK(import_glb(maker, &warnings).meshes.at(0).positions[1] == Vector3f(1, 0, 0));
    CHECK(warnings ==
          std::vector<std::string>{
              "meshes[0].primitives[0]: has a skin but no JOINTS_0 and WEIGHTS_0, drawn as it is"});
  }
}
