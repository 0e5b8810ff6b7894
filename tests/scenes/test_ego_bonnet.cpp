#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "scenes/ego_bonnet.h"

using namespace cps;

TEST_CASE("the bonnet moves with the car, has its documented size, and faces up and out") {
  Scene scene;
  add_ego_bonnet(scene);
  REQUIRE(scene.instances.size() == 1);
  CHECK(scene.instances[0].rides);
  const Mesh& mesh = scene.meshes[scene.instances[0].mesh];
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  CHECK(box.min().x() == Approx(2.15));
  CHECK(box.max().x() == Approx(3.55));
  CHECK(box.max().z() == Approx(1.0));
  CHECK(box.min().z() > 0.4);  // above the road and the bumper
  CHECK(box.max().y() == Approx(0.86));
  CHECK(box.min().y() == Approx(-0.86));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3f face =
        (mesh.positions[t.y()] - mesh.positions[t.x()]).cross(mesh.positions[t.z()] - mesh.positions[t.x()]);
    CHECK(face.z() > 0);
    CHECK(face.dot(mesh.normals[t.x()]) > 0);
  }
}
