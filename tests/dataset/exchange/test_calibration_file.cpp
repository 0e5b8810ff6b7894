#include <catch2/catch.hpp>
#include <filesystem>
#include <limits>
#include <opencv2/core.hpp>

#include "tests/dataset/exchange/read_text.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

// p1, p2 and k3 all differ, the centre is off and no number is short: any exchange, any half pixel, any
// rounding shows.
const CalibratedCamera odd{
    "02",
    {.width = 1392,
     .height = 512,
     .fx = 984.2439123456789,
     .fy = 980.8141 / 3,
     .cx = 690.1234,
     .cy = 233.1966},
    {.k1 = -0.3728755, .k2 = 0.2037299 / 7, .k3 = -0.07233722, .p1 = 2.219027e-3, .p2 = -1.383707e-9 / 3}};

fs::path fresh_file(const std::string& name) {
  const fs::path file = file_of(name, "");
  fs::remove(file);
  return file;
}

std::vector<CalibratedCamera> from_text(const std::string& name, const std::string& text) {
  return read_calibration(file_of(name, text));
}

}  // namespace

TEST_CASE("every format reads back what it wrote") {
  const std::pair<CalibrationFormat, const char*> cases[] = {
      {CalibrationFormat::cps, "calibration.json"}, {CalibrationFormat::opencv_yaml, "a.yml"},
      {CalibrationFormat::opencv_xml, "a.xml"},     {CalibrationFormat::colmap, "cameras.txt"},
      {CalibrationFormat::ros, "ros.yaml"},         {CalibrationFormat::kitti, "kitti.txt"},
      {CalibrationFormat::kalibr, "camchain.yaml"}, {CalibrationFormat::nerfstudio, "transforms.json"}};
  for (const auto& [format, name] : cases) {
    INFO(to_string(format));
    CHECK(calibration_format_from_string(to_string(format)) == format);
    CalibratedCamera written = odd;
    if (format == CalibrationFormat::kalibr) written.distortion.k3 = 0;
    const fs::path file = fresh_file(name);
    write_calibration(file, format, std::vector{written});
    const std::vector<CalibratedCamera> cameras = read_calibration(file);
    REQUIRE(cameras.size() == 1);
    CalibratedCamera read = cameras.front();
    if (format == CalibrationFormat::colmap || format == CalibrationFormat::nerfstudio) {
      // + .5 − .5 costs the last bit at most.
      constexpr double last_bit = std::numeric_limits<double>::epsilon();
      CHECK(std::abs(read.pinhole.cx - odd.pinhole.cx) <= last_bit * odd.pinhole.cx);
      CHECK(std::abs(read.pinhole.cy - odd.pinhole.cy) <= last_bit * odd.pinhole.cy);
      read.pinhole.cx = odd.pinhole.cx;
      read.pinhole.cy = odd.pinhole.cy;
    }
    CHECK(read.pinhole == written.pinhole);
    CHECK(read.distortion == written.distortion);
  }
}

TEST_CASE("formats for several cameras keep them apart, formats for one refuse several") {
  CalibratedCamera second = odd;
  second.name = "03";
  second.pinhole.cx = 711;
  const std::vector<CalibratedCamera> both{odd, second};
  for (CalibrationFormat format :
       {CalibrationFormat::kitti, CalibrationFormat::colmap, CalibrationFormat::nerfstudio}) {
    const fs::path file = fresh_file(format == CalibrationFormat::nerfstudio ? "two.json" : "two.txt");
    write_calibration(file, format, both);
    const std::vector<CalibratedCamera> read = read_calibration(file);
    REQUIRE(read.size() == 2);
    CHECK(read[0].name == "02");
    CHECK(read_camera(file, "03").pinhole.cx == Approx(711));
    CHECK_THROWS_WITH(read_camera(file, ""), Catch::Contains("choose one of 02 03"));
    CHECK_THROWS_WITH(read_camera(file, "7"), Catch::Contains("'7' is none of"));
  }
  const fs::path file = fresh_file("two.yml");
  CHECK_THROWS_WITH(write_calibration(file, CalibrationFormat::opencv_yaml, both),
                    Catch::Contains("one camera"));
  CHECK_THROWS_WITH(write_calibration(file, CalibrationFormat::kalibr, both), Catch::Contains("k3 is not 0"));
  CHECK_FALSE(fs::exists(file));
}

TEST_CASE("OpenCV reads our files, and we read OpenCV's") {
  for (const char* name : {"opencv.yml", "opencv.xml"}) {
    const bool is_xml = std::string(name).ends_with("xml");
    const fs::path file = fresh_file(name);
    write_calibration(file, is_xml ? CalibrationFormat::opencv_xml : CalibrationFormat::opencv_yaml,
                      std::vector{odd});
    cv::Mat k, d;
    cv::FileStorage read(file.string(), cv::FileStorage::READ);
    read["camera_matrix"] >> k;
    read["distortion_coefficients"] >> d;
    CHECK(int(read["image_width"]) == 1392);
    REQUIRE((k.rows == 3 && d.total() == 5));
    CHECK(k.at<double>(0, 2) == Approx(odd.pinhole.cx).epsilon(1e-15));
    CHECK(k.at<double>(1, 1) == Approx(odd.pinhole.fy).epsilon(1e-15));
    CHECK(d.at<double>(2) == Approx(odd.distortion.p1).epsilon(1e-15));
    CHECK(d.at<double>(3) == Approx(odd.distortion.p2).epsilon(1e-15));
    CHECK(d.at<double>(4) == Approx(odd.distortion.k3).epsilon(1e-15));

    cv::FileStorage write(file.string(), cv::FileStorage::WRITE);
    write << "calibration_time"
          << "Mon"
          << "image_width" << 1392 << "image_height" << 512 << "camera_matrix" << k
          << "distortion_coefficients" << d;
    write.release();
    const CalibratedCamera back = read_calibration(file).front();
    CHECK(back.pinhole.cy == Approx(odd.pinhole.cy).epsilon(1e-15));
    CHECK(back.distortion.p2 == Approx(odd.distortion.p2).epsilon(1e-15));
    CHECK(back.distortion.k3 == Approx(odd.distortion.k3).epsilon(1e-15));
  }
}

TEST_CASE("files of other programs are read") {
  const Distortion lens{.k1 = -0.3, .k2 = 0.1, .k3 = 0.05, .p1 = 0.001, .p2 = 0.002};
  const auto check = [](const std::vector<CalibratedCamera>& cameras, const std::string& name,
                        const Pinhole& camera, const Distortion& distortion) {
    REQUIRE(cameras.size() == 1);
    CHECK(cameras.front() == CalibratedCamera{name, camera, distortion});
  };
  check(
      from_text("cameras.txt",
                "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, "
                "PARAMS[]\n# Number of cameras: 1\n\n3 FULL_OPENCV 640 480 500 501 320.5 240 -0.3 0.1 0.001 "
                "0.002 0.05 0 0 0\n"),
      "3", {640, 480, 500, 501, 320, 239.5}, lens);
  check(from_text("cameras.txt", "1 SIMPLE_RADIAL 640 480 500 320.5 240 -0.3\n"), "1",
        {640, 480, 500, 500, 320, 239.5}, {.k1 = -0.3});
  check(from_text("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500 320.5 240\r\n"), "1",
        {640, 480, 500, 500, 320, 239.5}, {});
  check(from_text(
            "ost.yaml",
            "image_width: 640\nimage_height: 480\ncamera_name: narrow_stereo\ncamera_matrix:\n  rows: 3\n  "
            "cols: 3\n  data: [500., 0., 320, 0, 501, 2.395e+02, 0, 0, 1]\ndistortion_model: "
            "plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [-0.3, .1, 0.001, 0.002, "
            "0.05]\n"),
        "narrow_stereo", {640, 480, 500, 501, 320, 239.5}, lens);
  check(from_text(
            "camchain.yaml",
            "cam0:\n  cam_overlaps: []\n  camera_model: pinhole\n  distortion_coeffs: [-0.3, 0.1, 0.001, "
            "0.002]\n  distortion_model: radtan\n  intrinsics: [500, 501, 320, 239.5]\n  resolution: [640, "
            "480]\n  rostopic: /cam0/image_raw\n"),
        "cam0", {640, 480, 500, 501, 320, 239.5}, {.k1 = -0.3, .k2 = 0.1, .p1 = 0.001, .p2 = 0.002});
  check(
      from_text("transforms.json",
                R"({"camera_model": "OPENCV", "fl_x": 500, "fl_y": 501, "cx": 320.5, "cy": 240.0, "w": 640.0,
                  "h": 480, "k1": -0.3, "k2": 0.1, "k3": 0.05, "p1": 0.001, "p2": 0.002,
                  "frames": [{"file_path": "images/a.png", "transform_matrix": [[1]]}]})"),
      "transforms", {640, 480, 500, 501, 320, 239.5}, lens);
  check(from_text(
            "opencv.yml",
            "%YAML:1.0\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   "
            "cols: 3\n   dt: d\n   data: [ 500., 0., 320., 0., 501., 2.3950000000000000e+02, 0., 0.,\n       "
            "1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 8\n   cols: 1\n   dt: d\n   data: [ "
            "-.3, 0.1, 0.001, 0.002, 0.05, 0., 0., 0. ]\n"),
        "opencv", {640, 480, 500, 501, 320, 239.5}, lens);
  const std::vector<CalibratedCamera> kitti = from_text(
      "calib_cam_to_cam.txt",
      "calib_time: 09-Jan-2012 13:57:47\ncorner_dist: 9.95e-02\nS_00: 6.4e+02 4.8e+02\nK_00: 500 0 320 0 501 "
      "239.5 0 0 1\nD_00: -0.3 0.1 0.001 0.002 0.05\nR_00: 1 0 0\nS_01: 640 480\nK_01: 400 0 320 0 501 239.5 "
      "0 0 "
      "1\nD_01: 0 0 0 0 0\n");
  REQUIRE(kitti.size() == 2);
  CHECK(kitti[0] == CalibratedCamera{"00", {640, 480, 500, 501, 320, 239.5}, lens});
  CHECK(kitti[1].pinhole.fx == 400);
}

TEST_CASE("impossible numbers and unknown lens models are refused by name") {
  const auto colmap = [](const std::string& line) { return refusal("cameras.txt", "1 " + line + "\n"); };
  CHECK_THAT(colmap("FOV 640 480 500 501 320 240 0.9"), Catch::Contains("MODEL FOV is not supported"));
  CHECK_THAT(colmap("THIN_PRISM_FISHEYE 640 480 500 501 320 240 0 0 0 0 0 0 0 0"),
             Catch::Contains("THIN_PRISM_FISHEYE"));
  CHECK_THAT(colmap("OPENCV 640 480 500 501 320 240 0 0"), Catch::Contains("needs a size and 8 parameters"));
  CHECK_THAT(colmap("OPENCV 640 480 0 501 320 240 0 0 0 0"), Catch::Contains("fx, fy"));
  CHECK_THAT(colmap("OPENCV 640 480 500 501 320 240 nan 0 0 0"), Catch::Contains("must be finite"));
  CHECK_THAT(colmap("OPENCV 640 480 500 501 640.5 240 0 0 0 0"), Catch::Contains("principal point"));
  CHECK_THAT(colmap("OPENCV 640 4800000 500 501 320 240 0 0 0 0"),
             Catch::Contains("HEIGHT: must be a size in whole pixels"));
  CHECK_THAT(colmap("OPENCV 640 400000 500 501 320 240 0 0 0 0"), Catch::Contains("width, height"));
  CHECK_THAT(colmap("OPENCV 640 x 500 501 320 240 0 0 0 0"), Catch::Contains("'x' is not a number"));
  const auto kalibr = [](const std::string& models) {
    return refusal("camchain.yaml", "cam0: {" + models +
                                        ", intrinsics: [500, 500, 320, 240], resolution: [640, 480], "
                                        "distortion_coeffs: [0, 0, 0, 0]}\n");
  };
  CHECK_THAT(kalibr("camera_model: omni, distortion_model: radtan"),
             Catch::Contains("intrinsics: must be 5 numbers, not 4"));
  CHECK_THAT(kalibr("camera_model: pinhole, distortion_model: fov"),
             Catch::Contains("distortion_model: is fov, a lens model that cps does not read"));
  CHECK_THAT(kalibr("camera_model: pinhole"), Catch::Contains("distortion_model: is missing"));
  CHECK_THAT(refusal("a.json", "{\"K\": 3}"), Catch::Contains("K: must be 3 rows"));
  CHECK_THAT(refusal("a.json", "{\"fl_x\": "), Catch::Contains("is not JSON"));
  CHECK_THAT(refusal("a.json", "{}"), Catch::Contains("no calibration in it"));
  CHECK_THAT(refusal("a.yaml", "camera_matrix: [1, 2\nb"), Catch::Contains("is not YAML"));
  CHECK_THAT(refusal("a.yaml", "camera_matrix: 7\nimage_width: 6\nimage_height: 5\n"),
             Catch::Contains("camera_matrix: must be a list of numbers"));
  CHECK_THAT(refusal("a.yaml", "camera_matrix: {rows: 3}\nimage_width: 6\nimage_height: 5\n"),
             Catch::Contains("data: is missing"));
  CHECK_THAT(refusal("a.xml", "<opencv_storage><a>"), Catch::Contains("is not XML"));
  CHECK_THAT(refusal("kitti.txt", "K_00: 1 0 0 0 1 0 0 0 1\n"), Catch::Contains("S_00: is missing"));
  CHECK_THAT(refusal("kitti.txt", "S_00: 640 480\nK_00: 500 1 320 0 500 240 0 0 1\nD_00: 0 0 0 0 0\n"),
             Catch::Contains("K_00: has skew"));
  CHECK_THAT(refusal("empty.txt", " \n"), Catch::Contains("is empty"));
  CHECK_THAT(refusal("comment.txt", "# nothing\n"), Catch::Contains("has no camera"));
}
