#include <catch2/catch.hpp>
#include <fstream>

#include "sampler/recipe/rig_file.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

const std::string front = "[front]\nforward_m = 1.5\nleft_m = -0.1\nup_m = 1.4\n";

Rig rig_of(const std::string& text) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "car.rig";
  std::ofstream(file) << text;
  return read_rig(file);
}

}  // namespace

TEST_CASE("a rig file gives cameras in its order, angles 0 unless it says") {
  const Rig rig =
      rig_of("# two\n" + front + "[rear-2]\nup_m = 1\nleft_m = 0\nforward_m=-0.5\nyaw_deg = 180 # back\n");
  REQUIRE(rig.cameras.size() == 2);
  CHECK(rig.cameras[0].name == "front");
  CHECK(rig.cameras[0].position_m == Eigen::Vector3d(1.5, -0.1, 1.4));
  CHECK(rig.cameras[0].yaw_deg == 0);
  CHECK(rig.cameras[1].name == "rear-2");
  CHECK(rig.cameras[1].yaw_deg == 180);
  CHECK(to_text(rig_of(to_text(rig))) == to_text(rig));
}

TEST_CASE("a rig file that cannot be is refused by file, camera and key") {
  const std::pair<std::string, const char*> cases[] = {
      {"", "car.rig: has no camera"},
      {"forward_m = 1\n", "forward_m: belongs under a [camera]"},
      {"[a]\nforward_m = 1\nleft_m = 0\n", "a.up_m: is missing"},
      {front + "hight_m = 1\n", "front.hight_m: is none of forward_m, left_m, up_m, yaw_deg"},
      {front + "yaw_deg = left\n", "front.yaw_deg: is not a number"},
      {front + "yaw_deg = nan\n", "front: yaw_deg must be within"},
      {front + "yaw_deg = 1\nyaw_deg = 2\n", "front.yaw_deg: is given twice"},
      {front + "[b]\nforward_m = 1\nleft_m = 0\nup_m = 1\n" + front, "front.forward_m: is given twice"},
      {"[../x]\nforward_m = 1\nleft_m = 0\nup_m = 1\n", "must be 1 to 64 letters"},
      {front + "up_m\n", "car.rig: "},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK_THROWS_WITH(rig_of(text),
                      Catch::Contains("car.rig: ") && Catch::Contains(expected) && !Catch::Contains("\n"));
  }
  CHECK_THROWS_WITH(read_rig("/no/such.rig"), "/no/such.rig: cannot be read; name a rig file");
}

TEST_CASE("rigs are found as named or beside the recipe, and every one we ship is valid") {
  CHECK(find_rig("", "").cameras.size() == 1);
  CHECK_THROWS_WITH(find_rig("none.rig", CPS_RECIPES), Catch::Contains("rig = none.rig"));
  CHECK(find_rig("surround.rig", CPS_RECIPES).cameras.size() == 6);
  // A recipe without a rig has the camera of single.rig.
  CHECK(to_text(find_rig("single.rig", CPS_RECIPES)) == to_text(Rig{}));
  const Rig kitti = find_rig("kitti.rig", CPS_RECIPES);
  REQUIRE(kitti.cameras.size() == 4);
  const auto baseline = [&](int a, int b) {
    return (kitti.cameras[a].position_m - kitti.cameras[b].position_m).norm();
  };
  // |T_01|, |T_02| and |T_03| of calib_cam_to_cam.txt, 2011_09_26.
  CHECK(baseline(0, 1) == Approx(0.53717).margin(2e-4));
  CHECK(baseline(0, 2) == Approx(0.05962).margin(2e-4));
  CHECK(baseline(0, 3) == Approx(0.47317).margin(2e-4));
}
