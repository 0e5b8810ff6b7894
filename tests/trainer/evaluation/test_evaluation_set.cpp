#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "files/files.h"
#include "numbers/angles.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/evaluation_set.h"

using namespace cps;

namespace {

/// KITTI's own lines for its camera 0 of 2011_09_26.
constexpr const char* calibration =
    "calib_time: 09-Jan-2012 13:57:47\n"
    "S_00: 1.392000e+03 5.120000e+02\n"
    "K_00: 9.842439e+02 0.000000e+00 6.900000e+02 0.000000e+00 9.808141e+02 2.331966e+02 0.000000e+00 "
    "0.000000e+00 1.000000e+00\n"
    "D_00: -3.728755e-01 2.037299e-01 2.219027e-03 1.383707e-03 -7.233722e-02\n";

}  // namespace

TEST_CASE("KITTI raw folders are found with the calibration of their date") {
  const TemporaryFolder folder;
  const std::filesystem::path date = folder.path / "2011_09_26";
  CHECK_THROWS_WITH(kitti_evaluation_set(folder.path),
                    Catch::StartsWith((folder.path / "calib_cam_to_cam.txt").string() + ": is missing"));
  write_file(date / "calib_cam_to_cam.txt", std::string_view(calibration));
  CHECK_THROWS_WITH(kitti_evaluation_set(folder.path), Catch::Contains("holds no <drive>/image_00/data"));
  for (const char* drive : {"drive_0002_extract", "drive_0001_extract"})
    for (const char* frame : {"0000000007.png", "0000000001.png", "timestamps.txt"})
      write_file(date / drive / "image_00/data" / frame, std::string_view("x"));
  for (const std::filesystem::path& root : {folder.path, date}) {
    const EvaluationSet set = kitti_evaluation_set(root);
    REQUIRE(set.images.size() == 4);
    CHECK(set.images[0].file == date / "drive_0001_extract/image_00/data/0000000001.png");
    CHECK(set.images[3].file == date / "drive_0002_extract/image_00/data/0000000007.png");
    CHECK(set.images[0].camera == "KITTI 00");
    CHECK(set.images[0].truth.pinhole.fy == 980.8141);
    CHECK(set.images[0].truth.distortion ==
          Distortion{-.3728755, .2037299, -.07233722, .002219027, .001383707});
    CHECK(degrees(hfov_rad(set.images[0].truth.pinhole)) == Approx(70.53).margin(.01));
    std::set<int> clusters;
    for (const EvaluationImage& image : set.images) clusters.insert(image.cluster);
    CHECK(clusters.size() == 4);
  }
  write_file(date / "calib_cam_to_cam.txt", std::string_view("S_00: 1392 512\nK_00: 1 2 3\n"));
  CHECK_THROWS_WITH(kitti_evaluation_set(folder.path), Catch::Contains("K_00"));
}

TEST_CASE("all four KITTI cameras can be measured, one of which folds just beyond its corners") {
  // Cameras 01, 02 and 03 of 2011_09_26.
  const std::vector<CalibratedCamera> cameras{{"01",
                                               {1392, 512, 989.5267, 987.8386, 702.0, 245.559},
                                               {-.3644661, .1790019, -.05314062, .001148107, -.0006298563}},
                                              {"02",
                                               {1392, 512, 959.7910, 956.9251, 696.0217, 224.1806},
                                               {-.3691481, .1968681, -.06770705, .001353473, .0005677587}},
                                              {"03",
                                               {1392, 512, 903.7596, 901.9653, 695.7519, 224.2509},
                                               {-.3639558, .1788651, -.05382460, .0006029694, -.0003922424}}};
  for (const CalibratedCamera& camera : cameras) {
    const auto rays = ray_grid(camera);
    REQUIRE(rays);
    CHECK(rays->pixels.size() >= .9 * 24 * 9);
    CHECK(reprojection_error_px(*rays, camera) < 1e-6);
  }
  CHECK_FALSE(is_one_to_one(cameras[2]));
}

TEST_CASE("images of one place are one cluster, whatever their lens") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(
      folder.path / "data", {.fields_of_view = 2, .lenses_per_part = 3, .train_places = 2, .test_places = 2});
  const EvaluationSet set = evaluation_set(dataset, Part::test);
  std::map<int, std::set<std::string>> names;
  for (const EvaluationImage& image : set.images) {
    const std::filesystem::path file(image.name);
    names[image.cluster].insert((*file.begin() / file.filename()).string());
  }
  CHECK(set.images.size() == 12);
  CHECK(names.size() == 4);  // two fields of view, two places each
  for (const auto& [cluster, of_cluster] : names) CHECK(of_cluster.size() == 1);
}

TEST_CASE("a folder of pictures has one camera") {
  const TemporaryFolder folder;
  const CalibratedCamera camera{"dash", pinhole_from_hfov(640, 360, 1), {-.2, 0, 0, 0, 0}};
  CHECK_THROWS_WITH(picture_evaluation_set(folder.path, camera), Catch::Contains("no pictures"));
  for (const char* name : {"b.JPG", "a.png", "readme.txt"})
    write_file(folder.path / name, std::string_view("x"));
  const EvaluationSet set = picture_evaluation_set(folder.path, camera);
  REQUIRE(set.images.size() == 2);
  CHECK(set.images[0].name == "a.png");
  CHECK(set.images[1].camera == "dash");
  CHECK_THROWS_WITH(picture_evaluation_set(folder.path, {"fold", camera.pinhole, {-5, 0, 0, 0, 0}}),
                    Catch::Contains("not one-to-one"));
}
