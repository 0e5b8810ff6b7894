#include <catch2/catch.hpp>

#include "scenes/drive/driven_scene.h"
#include "tests/scenes/gltf/gltf_maker.h"

using namespace cps;

namespace {

/// Writes the file as place.glb and loads it; messages of errors begin with `place.glb`.
DrivenScene load(const GltfMaker& maker, const DriveOptions& options) {
  const TemporaryFolder folder;
  const std::vector<unsigned char> glb = maker.glb();
  write_file(folder.path / "place.glb", glb.data(), glb.size());
  try {
    return load_driven_scene(folder.path / "place.glb", options);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()).substr(folder.path.string().size() + 1));
  }
}

GltfMaker with_lane() {
  GltfMaker maker = one_triangle();
  maker.json["scenes"][0]["extras"]["cps_lanes"] = {
      {{"street", "A"}, {"width_m", 3}, {"points", {{0, 0, 0}, {30, 0, -40}}}}};
  return maker;
}

}  // namespace

TEST_CASE("a scene with lanes in metres is left as it is, without a note") {
  const DrivenScene driven = load(with_lane(), {});
  CHECK(driven.metres_per_unit == 1);
  CHECK(driven.note.empty());
  CHECK(driven.scene.lanes.at(0).points.at(1) == Eigen::Vector3f(30, 0, -40));
}

TEST_CASE("a scene scaled by an option says so") {
  const DrivenScene driven = load(with_lane(), {.metres_per_unit = 0.1});
  CHECK(driven.scene.lanes.at(0).points.at(1) == Eigen::Vector3f(3, 0, -4));
  CHECK(driven.note == "place.glb: 0.1 m per unit, 1 lanes, 5 m");
}

TEST_CASE("a scene without drivable ground is refused with its size") {
  CHECK_THROWS_WITH(
      load(one_triangle(), {}),
      "place.glb: no way to drive was found: no flat ground has things beside it (10 x 10 x 0 m); "
      "set --metres_per_unit or name a --route");
}
