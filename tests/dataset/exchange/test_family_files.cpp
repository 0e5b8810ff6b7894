#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "distortion/models/projection.h"
#include "tests/dataset/exchange/read_text.h"

/// Files of other lens families, in the style of the programs that write them. The numbers are made up.
using namespace cps;

namespace {

const Pinhole pinhole{640, 480, 300, 301, 318.25, 241.75};
const KannalaBrandt fisheye{.k1 = -0.02, .k2 = 0.01, .k3 = 0.003, .k4 = -0.001};
const Distortion radtan{.k1 = -0.2, .k2 = 0.1, .p1 = 0.003, .p2 = -0.001};

void check_camera(const ModelCamera& camera, const LensModel& lens) {
  CHECK(camera.pinhole == pinhole);
  CHECK(camera.lens == lens);
}

std::string opencv(const std::string& keys, const std::string& size, const std::string& coefficients) {
  return "%YAML:1.0\n---\ncalibration_time: \"Mon\"\nimage_width: 640\nimage_height: 480\n" + keys +
         "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 300., 0., 318.25, 0., "
         "301., 241.75, 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n" +
         size + "   dt: d\n   data: [ " + coefficients + " ]\n";
}
const std::string four = "   rows: 4\n   cols: 1\n", fisheye_numbers = "-0.02, 0.01, 0.003, -0.001";

std::string kalibr(const std::string& camera, const std::string& distortion, const std::string& coefficients,
                   const std::string& before_focal) {
  return "cam0:\n  cam_overlaps: []\n  camera_model: " + camera + "\n  distortion_coeffs: [" + coefficients +
         "]\n  distortion_model: " + distortion + "\n  intrinsics: [" + before_focal +
         "300, 301, 318.25, 241.75]\n  resolution: [640, 480]\n  rostopic: /cam0/image_raw\n";
}

/// The pixel of a ray.
Eigen::Vector2d pixel(const ModelCamera& camera, const Eigen::Vector3d& ray) {
  return to_pixel(camera.pinhole, project(camera.lens, ray).point);
}

const std::vector<Eigen::Vector3d> rays{{0.3, -0.2, 1}, {-0.5, 0.4, 1}, {0.9, 0.7, 1}};

}  // namespace

TEST_CASE("OpenCV's fisheye, rational and omnidirectional files") {
  check_camera(camera_of("a.yml", opencv("fisheye_model: 1\n", four, fisheye_numbers)), fisheye);
  check_camera(camera_of("a.yml", opencv("camera_model: \"fisheye\"\n", four, fisheye_numbers)), fisheye);
  check_camera(camera_of("a.yml", opencv("distortion_type: kannala_brandt4\n", four, fisheye_numbers)),
               fisheye);
  check_camera(camera_of("a.yml", opencv("fisheye_model: 0\n", four, "-0.2, 0.1, 0.003, -0.001")), radtan);
  check_camera(
      camera_of("a.yml",
                opencv("", "   rows: 1\n   cols: 8\n", "0.4, -0.07, 0.003, -0.001, 0.02, 0.5, 0.06, 0.002")),
      RationalLens{
          .k1 = 0.4, .k2 = -0.07, .k3 = 0.02, .k4 = 0.5, .k5 = 0.06, .k6 = 0.002, .p1 = 0.003, .p2 = -0.001});
  const UnifiedSpherical sphere{.xi = 1.25, .distortion = radtan};
  const std::string one_row = "   rows: 1\n   cols: 4\n", plane_numbers = "-0.2, 0.1, 0.003, -0.001";
  check_camera(camera_of("a.yml", opencv("xi: 1.25\n", one_row, plane_numbers)), sphere);
  check_camera(
      camera_of("a.yml", opencv("xi: !!opencv-matrix\n   rows: 1\n   cols: 1\n   dt: d\n   data: [ 1.25 ]\n",
                                one_row, plane_numbers)),
      sphere);
  check_camera(camera_of("a.yml", opencv("camera_model: omnidir\nxi: 0.\n", one_row, plane_numbers)),
               UnifiedSpherical{.xi = 0, .distortion = radtan});
  // Numbers that do not fit the model that is named.
  CHECK_THAT(
      refusal("a.yml", opencv("fisheye_model: 1\n", "   rows: 5\n   cols: 1\n", fisheye_numbers + ", 0.1")),
      Catch::Contains("must be the 4 numbers k1 k2 k3 k4"));
  CHECK_THAT(refusal("a.yml", opencv("fisheye_model: 1\n", "   rows: 2\n   cols: 1\n", "-0.02, 0.01")),
             Catch::Contains("must be the 4 numbers k1 k2 k3 k4"));
  CHECK_THAT(refusal("a.yml", opencv("xi: 1.25\n", "   rows: 1\n   cols: 5\n", plane_numbers + ", 0.1")),
             Catch::Contains("must be the 4 numbers k1 k2 p1 p2"));
  CHECK_THAT(refusal("a.yml", opencv("xi: -1.25\n", one_row, plane_numbers)), Catch::Contains("xi"));
  CHECK_THAT(refusal("a.yml", opencv("", "   rows: 1\n   cols: 12\n",
                                     "0.4, -0.07, 0.003, -0.001, 0.02, 0.5, 0.06, 0.002, 0.1, 0, 0, 0")),
             Catch::Contains("s1 is not 0"));
}

TEST_CASE("cameras of OpenCV's own files land where OpenCV's functions put them") {
  const auto k = cv::Matx33d(300, 0, 318.25, 0, 301, 241.75, 0, 0, 1);
  const auto file_with = [&](const cv::Mat& d, bool is_fisheye) {
    const std::filesystem::path file = file_of("written.yml", "");
    cv::FileStorage out(file.string(), cv::FileStorage::WRITE);
    out << "image_width" << 640 << "image_height" << 480 << "fisheye_model" << int(is_fisheye)
        << "camera_matrix" << cv::Mat(k) << "distortion_coefficients" << d;
    out.release();
    return read_model_camera(file, "");
  };
  const cv::Mat four_numbers = (cv::Mat_<double>(4, 1) << -0.02, 0.01, 0.003, -0.001);
  const cv::Mat eight = (cv::Mat_<double>(8, 1) << 0.4, -0.07, 0.003, -0.001, 0.02, 0.5, 0.06, 0.002);
  std::vector<cv::Point3d> points;
  for (const Eigen::Vector3d& ray : rays) points.emplace_back(ray.x(), ray.y(), ray.z());
  std::vector<cv::Point2d> expected;
  const auto compare = [&](const ModelCamera& camera) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Eigen::Vector2d at = pixel(camera, rays[i]);
      CHECK(at.x() == Approx(expected[i].x).epsilon(1e-12));
      CHECK(at.y() == Approx(expected[i].y).epsilon(1e-12));
    }
  };
  cv::fisheye::projectPoints(points, expected, cv::Vec3d(), cv::Vec3d(), k, four_numbers);
  compare(file_with(four_numbers, true));
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), k, eight, expected);
  compare(file_with(eight, false));
}

TEST_CASE("Kalibr's camera models, each with its order of intrinsics") {
  const std::string radtan_numbers = "-0.2, 0.1, 0.003, -0.001";
  check_camera(camera_of("a.yaml", kalibr("pinhole", "equidistant", fisheye_numbers, "")), fisheye);
  check_camera(camera_of("a.yaml", kalibr("pinhole", "radtan", radtan_numbers, "")), radtan);
  check_camera(camera_of("a.yaml", kalibr("omni", "radtan", radtan_numbers, "1.25, ")),
               UnifiedSpherical{.xi = 1.25, .distortion = radtan});
  check_camera(camera_of("a.yaml", kalibr("omni", "none", "", "1.25, ")), UnifiedSpherical{.xi = 1.25});
  check_camera(camera_of("a.yaml", kalibr("ds", "none", "", "-0.2, 0.55, ")),
               DoubleSphere{.xi = -0.2, .alpha = 0.55});
  check_camera(camera_of("a.yaml", kalibr("eucm", "none", "", "0.6, 1.1, ")),
               Eucm{.alpha = 0.6, .beta = 1.1});
  CHECK_THAT(refusal("a.yaml", kalibr("omni", "equidistant", fisheye_numbers, "1.25, ")),
             Catch::Contains("names another lens model"));
  CHECK_THAT(refusal("a.yaml", kalibr("ds", "radtan", radtan_numbers, "-0.2, 0.55, ")),
             Catch::Contains("names another lens model"));
  CHECK_THAT(refusal("a.yaml", kalibr("pinhole", "fov", "0.9", "")), Catch::Contains("is fov"));
  CHECK_THAT(refusal("a.yaml", kalibr("ds", "none", "", "-0.2, ")),
             Catch::Contains("must be 6 numbers, not 5"));
  CHECK_THAT(refusal("a.yaml", kalibr("eucm", "none", "", "1.6, 1.1, ")), Catch::Contains("alpha"));
  CHECK_THAT(refusal("a.yaml", kalibr("omni", "none", "0.1, 0, 0, 0", "1.25, ")),
             Catch::Contains("though distortion_model is none"));
}

TEST_CASE("COLMAP's fisheye models and EUCM") {
  const auto colmap = [](const std::string& model_and_numbers) {
    return camera_of("cameras.txt", "# Camera list\n1 " + model_and_numbers + "\n");
  };
  check_camera(colmap("OPENCV_FISHEYE 640 480 300 301 318.75 242.25 -0.02 0.01 0.003 -0.001"), fisheye);
  check_camera(
      colmap("FULL_OPENCV 640 480 300 301 318.75 242.25 0.4 -0.07 0.003 -0.001 0.02 0.5 0.06 0.002"),
      RationalLens{
          .k1 = 0.4, .k2 = -0.07, .k3 = 0.02, .k4 = 0.5, .k5 = 0.06, .k6 = 0.002, .p1 = 0.003, .p2 = -0.001});
  check_camera(colmap("EUCM 640 480 300 301 318.75 242.25 0.6 1.1"), Eucm{.alpha = 0.6, .beta = 1.1});
  CHECK(colmap("SIMPLE_FISHEYE 640 480 300 318.75 242.25").lens == LensModel(KannalaBrandt{}));
  CHECK(colmap("SIMPLE_RADIAL_FISHEYE 640 480 300 318.75 242.25 0.05").lens ==
        LensModel(KannalaBrandt{.k1 = 0.05}));
  CHECK(colmap("RADIAL_FISHEYE 640 480 300 318.75 242.25 0.05 -0.01").lens ==
        LensModel(KannalaBrandt{.k1 = 0.05, .k2 = -0.01}));
}

TEST_CASE("nerfstudio's and instant-ngp's fisheye cameras") {
  const std::string intrinsics =
      R"("w": 640, "h": 480, "fl_x": 300, "fl_y": 301, "cx": 318.75, "cy": 242.25, "k1": -0.02, "k2": 0.01,
         "k3": 0.003, "k4": -0.001, )";
  check_camera(
      camera_of("t.json", R"({"camera_model": "OPENCV_FISHEYE", )" + intrinsics + R"("frames": []})"),
      fisheye);
  const std::string ngp = "{\"camera_angle_x\": 1.6, " + intrinsics +
                          R"("p1": 0.0, "p2": 0.0, "is_fisheye": true, "aabb_scale": 32, "frames": []})";
  check_camera(camera_of("t.json", ngp), fisheye);
  CHECK_THAT(refusal("t.json", with(ngp, "true", "false")), Catch::Contains("k4: is -0.001"));
  CHECK_THAT(refusal("t.json", with(ngp, "\"p1\": 0.0", "\"p1\": 0.1")), Catch::Contains("p1: is 0.1"));
  // A fisheye without coefficients is an equidistant lens to one program and a pinhole to the other.
  const std::string plain = R"({"w": 640, "h": 480, "fl_x": 300, "cx": 318.75, "cy": 242.25, "frames": [])";
  CHECK_THAT(refusal("t.json", plain + R"(, "is_fisheye": true})"),
             Catch::Contains("is_fisheye: is given without"));
  CHECK(camera_of("t.json", plain + R"(, "camera_model": "OPENCV_FISHEYE"})").lens ==
        LensModel(KannalaBrandt{}));
}

TEST_CASE("ROS: equidistant and rational_polynomial, as files and as messages") {
  const std::string file =
      "image_width: 640\nimage_height: 480\ncamera_name: front\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: "
      "[300.0, 0.0, 318.25, 0.0, 301.0, 241.75, 0.0, 0.0, 1.0]\ndistortion_model: equidistant\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [-0.02, 0.01, 0.003, -0.001]\n";
  check_camera(camera_of("a.yaml", file), fisheye);
  check_camera(camera_of("a.yaml", with(file, "equidistant", "fisheye")), fisheye);
  const std::string message =
      "height: 480\nwidth: 640\ndistortion_model: \"equidistant\"\nD: [-0.02, 0.01, 0.003, -0.001, 0.0]\n"
      "K: [300.0, 0.0, 318.25, 0.0, 301.0, 241.75, 0.0, 0.0, 1.0]\n";
  check_camera(camera_of("a.yaml", message), fisheye);
  CHECK_THAT(refusal("a.yaml", with(message, "0.0]", "0.1]")), Catch::Contains("must be the 4 numbers"));
  const std::string rational =
      with(with(message, "equidistant", "rational_polynomial"), "[-0.02, 0.01, 0.003, -0.001, 0.0]",
           "[0.4, -0.07, 0.003, -0.001, 0.02, 0.5, 0.06, 0.002]");
  check_camera(
      camera_of("a.yaml", rational),
      RationalLens{
          .k1 = 0.4, .k2 = -0.07, .k3 = 0.02, .k4 = 0.5, .k5 = 0.06, .k6 = 0.002, .p1 = 0.003, .p2 = -0.001});
  CHECK_THAT(refusal("a.yaml", with(rational, "rational_polynomial", "plumb_bob")),
             Catch::Contains("k4 is not 0"));
  CHECK_THAT(refusal("a.yaml", with(rational, ", 0.002]", "]")), Catch::Contains("k4 k5 k6 must be given"));
}

TEST_CASE("EuRoC's and ORB-SLAM's fisheye cameras") {
  check_camera(
      camera_of("sensor.yaml",
                "sensor_type: camera\nresolution: [640, 480]\ncamera_model: pinhole\nintrinsics: [300, "
                "301, 318.25, 241.75]\ndistortion_model: equidistant\ndistortion_coefficients: [-0.02, "
                "0.01, 0.003, -0.001]\n"),
      fisheye);
  const std::string orb =
      "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"KannalaBrandt8\"\nCamera1.fx: 300.0\nCamera1.fy: 301.0\n"
      "Camera1.cx: 318.25\nCamera1.cy: 241.75\nCamera1.k1: -0.02\nCamera1.k2: 0.01\nCamera1.k3: 0.003\n"
      "Camera1.k4: -0.001\nCamera.width: 640\nCamera.height: 480\nCamera.fps: 20\n";
  check_camera(camera_of("a.yaml", orb), fisheye);
  CHECK_THAT(refusal("a.yaml", with(orb, "Camera1.k4: -0.001\n", "")), Catch::Contains("k4: is missing"));
  // The second camera's lens is its own, not the first one's.
  const std::filesystem::path stereo =
      file_of("stereo.yaml",
              "Camera.type: \"PinHole\"\nCamera.width: 640\nCamera.height: 480\nCamera.fx: 500\n"
              "Camera.fy: 501\nCamera.cx: 318\nCamera.cy: 241\nCamera.k1: -0.3\nCamera2.fx: 300\n"
              "Camera2.fy: 301\nCamera2.cx: 318.25\nCamera2.cy: 241.75\n");
  check_camera(read_model_camera(stereo, "Camera2"), Distortion{});
}

TEST_CASE("camodocal's KANNALA_BRANDT and MEI") {
  const std::string head =
      "%YAML:1.0\n---\nmodel_type: MEI\ncamera_name: left\nimage_width: 640\nimage_height: 480\n";
  const std::string mei =
      head +
      "mirror_parameters:\n   xi: 1.25\ndistortion_parameters:\n   k1: -0.2\n   k2: 0.1\n"
      "   p1: 0.003\n   p2: -0.001\nprojection_parameters:\n   gamma1: 300.\n   gamma2: 301.\n"
      "   u0: 318.25\n   v0: 241.75\n";
  check_camera(camera_of("a.yaml", mei), UnifiedSpherical{.xi = 1.25, .distortion = radtan});
  const std::string kannala =
      with(head, "MEI", "KANNALA_BRANDT") +
      "projection_parameters:\n   k2: -0.02\n   k3: 0.01\n   k4: 0.003\n   k5: -0.001\n"
      "   mu: 300.\n   mv: 301.\n   u0: 318.25\n   v0: 241.75\n";
  check_camera(camera_of("a.yaml", kannala), fisheye);
  CHECK_THAT(refusal("a.yaml", with(kannala, "   k5: -0.001\n", "")), Catch::Contains("k5: is missing"));
  CHECK_THAT(refusal("a.yaml", with(mei, "   xi: 1.25\n", "   mi: 1.25\n")),
             Catch::Contains("xi: is missing"));
  CHECK_THAT(refusal("a.yaml", with(mei, "MEI", "PINHOLE")), Catch::Contains("xi: is 1.25"));
}

TEST_CASE("Metashape's fisheye cameras follow its manual's formula") {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<calibration><projection>fisheye</projection><width>640</width>"
      "<height>480</height><f>300</f><cx>7.5</cx><cy>-3.25</cy><b1>2.5</b1><k1>-0.02</k1><k2>0.01</k2>"
      "<k3>0.003</k3><k4>-0.001</k4></calibration>";
  for (const ModelCamera& camera :
       {camera_of("a.xml", text), camera_of("a.xml", with(text, ">fisheye", ">equidistant_fisheye"))})
    for (const Eigen::Vector3d& ray : rays) {
      const double x0 = ray.x() / ray.z(), y0 = ray.y() / ray.z(), r0 = std::hypot(x0, y0);
      const double x = x0 * std::atan(r0) / r0, y = y0 * std::atan(r0) / r0, r2 = x * x + y * y;
      const double radial = 1 + r2 * (-0.02 + r2 * (0.01 + r2 * (0.003 + r2 * -0.001)));
      const Eigen::Vector2d at = pixel(camera, ray);
      CHECK(at.x() == Approx(320 + 7.5 + x * radial * 302.5 - 0.5).margin(1e-9));
      CHECK(at.y() == Approx(240 - 3.25 + y * radial * 300 - 0.5).margin(1e-9));
    }
  CHECK_THAT(refusal("a.xml", with(text, "<k4>", "<p1>0.1</p1><k4>")), Catch::Contains("p1: is 0.1"));
}

TEST_CASE("calibration.json of any family: all of its parameters, and nothing beside them") {
  const std::string text = R"({"model": "double_sphere", "params": {"xi": -0.2, "alpha": 0.55},
      "K": [[300, 0, 318.25], [0, 301, 241.75], [0, 0, 1]], "width": 640, "height": 480})";
  check_camera(camera_of("a.json", text), DoubleSphere{.xi = -0.2, .alpha = 0.55});
  CHECK_THAT(refusal("a.json", with(text, "\"xi\": -0.2, ", "")), Catch::Contains("xi is missing"));
  CHECK_THAT(refusal("a.json", with(text, "-0.2", "\"a\"")), Catch::Contains("xi: must be a number"));
  CHECK_THAT(refusal("a.json", with(text, "-0.2", "-2")), Catch::Contains("xi"));
  CHECK_THAT(refusal("a.json", with(text, "\"xi\"", "\"xy\"")), Catch::Contains("unknown parameter 'xy'"));
  CHECK_THAT(refusal("a.json", with(text, "double_sphere", "triple_sphere")),
             Catch::Contains("triple_sphere"));
  CHECK_THAT(refusal("a.json", with(text, "\"width\"", "\"k1\": 0.1, \"width\"")),
             Catch::Contains("k1: is 0.1"));
  CHECK_THAT(refusal("a.json", with(text, "\"model\": \"double_sphere\", ", "")),
             Catch::Contains("model: is missing"));
}
