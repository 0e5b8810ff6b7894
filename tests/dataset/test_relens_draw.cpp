#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "dataset/labels/label_check.h"
#include "dataset/relens_draw.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"

using namespace cps;

TEST_CASE("lenses for real pictures are certified, and the picture covers and resolves them") {
  const Pinhole straight = pinhole_from_hfov(1392, 512, radians(78));
  const std::vector<RelensGroup> groups = draw_relens_groups(straight, "cam", 5, {.lenses = 12, .seed = 3});
  REQUIRE(groups.size() == 12);
  std::set<std::string> folders;
  double least_deg = 180, most_deg = 0;
  for (const RelensGroup& group : groups) {
    folders.insert(group.folder);
    const Label& label = group.label;
    CHECK(check_label(label).faults.empty());
    CHECK(ImageSize{label.camera.width, label.camera.height} == ImageSize{696, 256});
    CHECK(label.part == Part::test);
    least_deg = std::min(least_deg, degrees(hfov_rad(label.camera)));
    most_deg = std::max(most_deg, degrees(hfov_rad(label.camera)));
    // Corners and middles of the rim show points that the straight picture holds.
    const FrameCertificate frame = certify_frame(label.distortion, label.camera, one_to_one);
    REQUIRE(frame.valid());
    for (double u : {-.5, .5 * 695, 695.5})
      for (double v : {-.5, .5 * 255, 255.5}) {
        const auto ideal =
            undistort(label.distortion, frame.rectangle, to_plane(label.camera, Eigen::Vector2d(u, v)));
        REQUIRE(ideal);
        const Eigen::Vector2d pixel = to_pixel(straight, *ideal);
        CHECK(pixel.x() > -.5);
        CHECK(pixel.x() < 1391.5);
        CHECK(pixel.y() > -.5);
        CHECK(pixel.y() < 511.5);
      }
  }
  CHECK(folders.size() == 12);
  CHECK(folders.begin()->starts_with("696x256_hfov078/cam_lens0005"));
  CHECK(most_deg - least_deg > 5);
  CHECK(most_deg < 78);

  // The same draws whatever else is asked for.
  const std::vector<RelensGroup> fewer = draw_relens_groups(straight, "cam", 5, {.lenses = 2, .seed = 3});
  CHECK(fewer[1].label.distortion == groups[1].label.distortion);
  CHECK(fewer[1].label.camera == groups[1].label.camera);
}

TEST_CASE("an output size for which the pictures are too coarse is refused in one line") {
  const Pinhole straight = pinhole_from_hfov(320, 240, radians(70));
  CHECK_THROWS_WITH(draw_relens_groups(straight, "cam", 1, {.size = {1280, 960}}),
                    Catch::StartsWith("camera cam: no lens found for 1280x960"));
}

TEST_CASE("invalid relens options are refused by name") {
  CHECK(RelensOptions{}.fault() == "");
  CHECK(RelensOptions{.lenses = 0}.fault() == "lenses: must lie in [1, 10000]");
  CHECK(RelensOptions{.narrowest = 1.5}.fault() == "narrowest: must lie in (0, 1]");
  RelensOptions options;
  options.lens.sequential_share = 2;
  CHECK_THAT(options.fault(), Catch::StartsWith("sequential_share: "));
}
