#include <catch2/catch.hpp>

#include "scenes/drive/top_view.h"
#include "tests/scenes/box.h"

using namespace cps;
using Eigen::Vector3f;

namespace {

/// A red roof of 20 m × 20 m, 10 m high, in the middle of a green ground of 200 m × 100 m, and a lane along x
/// at z = 30.
Scene house_on_a_lawn() {
  Scene scene;
  scene.materials.resize(2);
  scene.materials[0].base_color = {0, 0.5f, 0, 1};
  scene.materials[1].base_color = {0.5f, 0, 0, 1};
  scene.meshes = {box(), box()};
  scene.meshes[1].material = 1;
  Instance ground, house;
  ground.world_from_mesh = Eigen::Translation3f(0, -1, 0) * Eigen::Scaling(Vector3f(100, 1, 50));
  house.mesh = 1;
  house.world_from_mesh = Eigen::Translation3f(0, 5, 0) * Eigen::Scaling(Vector3f(10, 5, 10));
  scene.instances = {ground, house};
  scene.bounds = Eigen::AlignedBox3f(Vector3f(-100, -2, -50), Vector3f(100, 10, 50));
  scene.lanes = {{.street = "a", .points = {{-60, 0, 30}, {60, 0, 30}}}};
  return scene;
}

Vector3f pixel(const OIIO::ImageBuf& picture, int x, int y) {
  Vector3f value;
  picture.getpixel(x, y, value.data(), 3);
  return value;
}

}  // namespace

TEST_CASE("a top view shows surfaces in their colours where they are, with shadows and lanes") {
  const OIIO::ImageBuf picture = top_view(house_on_a_lawn(), "house on a lawn", 400);
  CHECK(picture.spec().width == 400);
  CHECK(picture.spec().height > 200);  // 100 m, and the caption
  CHECK(picture.spec().height < 280);
  const auto at = [&](double x, double z) {  // two pixels a metre
    return pixel(picture, static_cast<int>(2 * (x + 100)), static_cast<int>(2 * (z + 50)));
  };
  CHECK(at(5, 5).x() > 0.3f);
  CHECK(at(5, 5).y() < 0.05f);
  CHECK(at(-80, -20).y() > 0.3f);
  CHECK(at(-80, -20).x() < 0.05f);
  // The house, 10 m high, throws its shadow to the south-east (+x, +z), 7 m along each axis.
  CHECK(at(13, 13).y() < 0.8f * at(-80, -20).y());
  CHECK(at(-13, -13).y() == Approx(at(-80, -20).y()));
  CHECK(at(20, 20).y() == Approx(at(-80, -20).y()));
  // The lane: neither red nor green alone; beside it lawn.
  CHECK(at(0, 30) != at(0, 36));
  CHECK(at(0, 36) == at(-80, -20));
  CHECK(at(-60, 30) == at(0, 30));
  CHECK(at(65, 30) == at(-80, -20));
  // The dot at its start is wider than the line.
  CHECK(at(-60, 31.6) == at(0, 30));
  CHECK(at(0, 31.6) == at(-80, -20));
}

TEST_CASE("of a large scene with a short drive, the surroundings of the drive are shown") {
  Scene scene = house_on_a_lawn();
  scene.instances[0].world_from_mesh =
      Eigen::Translation3f(0, -1, 0) * Eigen::Scaling(Vector3f(5000, 1, 5000));
  scene.bounds = Eigen::AlignedBox3f(Vector3f(-5000, -2, -5000), Vector3f(5000, 10, 5000));
  const OIIO::ImageBuf picture = top_view(scene, "", 400);
  // 120 m of lane and 40 m at both ends are 200 m wide and 80 m high.
  CHECK(picture.spec().width == 400);
  CHECK(picture.spec().height < 160 + 60);
  CHECK(pixel(picture, 2 * 40, 2 * 40) != pixel(picture, 2, 2));  // the lane's start
}

TEST_CASE("a scene without lanes and a caption longer than the picture is wide are shown") {
  Scene scene = house_on_a_lawn();
  scene.lanes.clear();
  const int short_height = top_view(scene, "short", 400).spec().height;
  CHECK(top_view(scene, std::string(300, 'x') + " " + std::string(100, 'y'), 400).spec().height >
        short_height + 30);
}
