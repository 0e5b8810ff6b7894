#include <cmath>

#include "tests/dataset/exchange/read_text.h"

using namespace cps;

namespace {

/// fx, fy, the centre and all coefficients differ, so that any exchange shows.
const Pinhole foreign_pinhole{640, 480, 500, 501, 318.25, 241.75};
const Distortion lens{.k1 = -0.3, .k2 = 0.1, .p1 = 0.001, .p2 = -0.002};

CalibratedCamera only_camera_of(const std::string& name, const std::string& text, ImageSize size = {0, 0}) {
  const std::vector<CalibratedCamera> cameras = read_calibration(file_of(name, text), size);
  REQUIRE(cameras.size() == 1);
  return cameras.front();
}

void check_camera(const CalibratedCamera& camera, const Pinhole& expected, const Distortion& distortion) {
  CHECK(camera.pinhole == expected);
  CHECK(camera.distortion == distortion);
}

const std::string ros_message =
    "header:\n  seq: 1\n  frame_id: cam\nheight: 480\nwidth: 640\ndistortion_model: plumb_bob\n"
    "D: [-0.3, 0.1, 0.001, -0.002, 0.0]\nK: [500.0, 0.0, 318.25, 0.0, 501.0, 241.75, 0.0, 0.0, 1.0]\n"
    "R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\nbinning_x: 0\nbinning_y: 0\n";

}  // namespace

TEST_CASE("ROS messages: K and D, or k and d; parts of a sensor are refused") {
  check_camera(only_camera_of("a.yaml", ros_message), foreign_pinhole, lens);
  const std::string ros2 = with(with(ros_message, "\nD:", "\nd:"), "\nK:", "\nk:");
  check_camera(only_camera_of("a.yaml", ros2 + "---\n"), foreign_pinhole, lens);
  CHECK_THAT(refusal("a.yaml", with(ros_message, "plumb_bob", "thin_prism")),
             Catch::Contains("distortion_model: is thin_prism"));
  CHECK_THAT(refusal("a.yaml", with(ros_message, "binning_x: 0", "binning_x: 2")),
             Catch::Contains("binning_x"));
  CHECK_THAT(refusal("a.yaml", ros_message + "roi: {x_offset: 8, y_offset: 0, width: 64, height: 48}\n"),
             Catch::Contains("roi: x_offset"));
}

TEST_CASE("EuRoC's sensor.yaml") {
  const std::string euroc =
      "#General sensor definitions.\nsensor_type: camera\ncomment: cam0\nT_BS:\n  cols: 4\n  rows: 4\n"
      "  data: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\nrate_hz: 20\nresolution: [640, 480]\n"
      "camera_model: pinhole\nintrinsics: [500.0, 501.0, 318.25, 241.75]\n"
      "distortion_model: radial-tangential\ndistortion_coefficients: [-0.3, 0.1, 0.001, -0.002]\n";
  check_camera(only_camera_of("sensor.yaml", euroc), foreign_pinhole, lens);
  CHECK_THAT(refusal("sensor.yaml", with(euroc, "pinhole", "omni")),
             Catch::Contains("camera_model: is omni"));
  CHECK_THAT(refusal("sensor.yaml", with(euroc, "resolution: [640, 480]", "resolution: [640]")),
             Catch::Contains("resolution: must be 2 numbers, not 1"));
}

TEST_CASE("ORB-SLAM settings") {
  const std::string orb =
      "%YAML:1.0\n\nCamera.type: \"PinHole\"\nCamera.fx: 500.0\nCamera.fy: 501.0\nCamera.cx: 318.25\n"
      "Camera.cy: 241.75\nCamera.k1: -0.3\nCamera.k2: 0.1\nCamera.p1: 0.001\nCamera.p2: -0.002\n"
      "Camera.width: 640\nCamera.height: 480\nCamera.fps: 20.0\nORBextractor.nFeatures: 1200\n";
  check_camera(only_camera_of("a.yaml", orb), foreign_pinhole, lens);
  Distortion with_k3 = lens;
  with_k3.k3 = 0.05;
  check_camera(only_camera_of("a.yaml", orb + "Camera.k3: 0.05\n"), foreign_pinhole, with_k3);
  CHECK_THAT(refusal("a.yaml", with(orb, "PinHole", "KannalaBrandt8")),
             Catch::Contains("p1: is 0.001, a coefficient"));
  CHECK_THAT(refusal("a.yaml", orb + "Camera.k4: 0.01\n"), Catch::Contains("k4"));
  // Version 2 leaves the size out.
  const std::string sizeless = with(with(orb, "Camera.width: 640\n", ""), "Camera.height: 480\n", "");
  CHECK_THAT(refusal("a.yaml", sizeless), Catch::Contains("--size"));
  check_camera(only_camera_of("a.yaml", sizeless, {640, 480}), foreign_pinhole, lens);
  // Version 3 counts its cameras.
  const std::filesystem::path file = file_of(
      "stereo.yaml",
      "%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.width: 640\nCamera.height: 480\nCamera1.fx: 500.0\n"
      "Camera1.fy: 501.0\nCamera1.cx: 318.25\nCamera1.cy: 241.75\nCamera1.k1: -0.3\nCamera1.k2: 0.1\n"
      "Camera1.p1: 0.001\nCamera1.p2: -0.002\nCamera2.fx: 400.0\nCamera2.fy: 401.0\nCamera2.cx: 300.0\n"
      "Camera2.cy: 200.0\n");
  check_camera(read_camera(file, "Camera1"), foreign_pinhole, lens);
  check_camera(read_camera(file, "Camera2"), {640, 480, 400, 401, 300, 200}, {});
}

TEST_CASE("VINS and camodocal") {
  const std::string vins =
      "%YAML:1.0\n---\nmodel_type: PINHOLE\ncamera_name: front\nimage_width: 640\nimage_height: 480\n"
      "distortion_parameters:\n   k1: -0.3\n   k2: 0.1\n   p1: 0.001\n   p2: -0.002\n"
      "projection_parameters:\n   fx: 500.0\n   fy: 501.0\n   cx: 318.25\n   cy: 241.75\n";
  const CalibratedCamera camera = only_camera_of("a.yaml", vins);
  check_camera(camera, foreign_pinhole, lens);
  CHECK(camera.name == "front");
  CHECK_THAT(refusal("a.yaml", with(vins, "PINHOLE", "SCARAMUZZA")),
             Catch::Contains("model_type: is SCARAMUZZA"));
  // Another model's numbers under a wrong name.
  CHECK_THAT(refusal("a.yaml", with(vins, "PINHOLE", "KANNALA_BRANDT")), Catch::Contains("k1: is -0.3"));
  CHECK_THAT(refusal("a.yaml", vins + "mirror_parameters:\n   xi: 2.2\n"), Catch::Contains("xi: is 2.2"));
  CHECK_THAT(refusal("a.yaml", with(vins, "PINHOLE", "MEI")), Catch::Contains("gamma1: is missing"));
}

TEST_CASE("OpenCV 2.4's capitals, and matrices as nested lists") {
  check_camera(
      only_camera_of("a.xml",
                     "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_Width>640</image_Width>\n"
                     "<image_Height>480</image_Height>\n<Camera_Matrix type_id=\"opencv-matrix\">"
                     "<rows>3</rows><cols>3</cols><dt>d</dt><data>500. 0. 318.25 0. 501. 241.75 0. "
                     "0. 1.</data></Camera_Matrix>\n<Distortion_Coefficients "
                     "type_id=\"opencv-matrix\"><rows>4</rows><cols>1</cols><dt>d</dt><data>-0.3 0.1 "
                     "0.001 -0.002</data></Distortion_Coefficients>\n</opencv_storage>\n"),
      foreign_pinhole, lens);
  check_camera(only_camera_of("a.json",
                              R"({"image_size": [640, 480], "dist_coeffs": [[-0.3, 0.1, 0.001, -0.002, 0]],
                              "camera_matrix": [[500, 0, 318.25], [0, 501, 241.75], [0, 0, 1]]})"),
               foreign_pinhole, lens);
}

TEST_CASE("nerfstudio: models by name, and a frame's own numbers override the file's") {
  const std::string simple =
      R"({"camera_model": "SIMPLE_RADIAL", "w": 640, "h": 480, "fl_x": 500, "cx": 318.75, "cy": 242.25,
          "k1": -0.3, "frames": [{"file_path": "a.png"}, {"file_path": "b.png", "k1": -0.2, "fl_x": 510}]})";
  const std::filesystem::path file = file_of("transforms.json", simple);
  check_camera(read_camera(file, "b.png"), {640, 480, 510, 510, 318.25, 241.75}, {.k1 = -0.2});
  CHECK_THAT(refusal("transforms.json", with(simple, "SIMPLE_RADIAL", "EQUIRECTANGULAR")),
             Catch::Contains("camera_model: is EQUIRECTANGULAR"));
}

TEST_CASE("Metashape's frame cameras follow its manual's formula") {
  const CalibratedCamera camera = only_camera_of(
      "a.xml",
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<calibration><projection>frame</projection><width>640</width>"
      "<height>480</height><f>500</f><cx>7.5</cx><cy>-3.25</cy><b1>2.5</b1><k1>-0.3</k1><k2>0.1</k2>"
      "<k3>0.05</k3><p1>0.001</p1><p2>-0.002</p2><date>2024-01-01T00:00:00Z</date></calibration>");
  for (const auto& [x, y] : {std::pair{0.3, -0.2}, {-0.5, 0.4}, {0.1, 0.45}}) {
    const double r2 = x * x + y * y, radial = 1 - 0.3 * r2 + 0.1 * r2 * r2 + 0.05 * r2 * r2 * r2;
    const double xd = x * radial + 0.001 * (r2 + 2 * x * x) + 2 * -0.002 * x * y;
    const double yd = y * radial + -0.002 * (r2 + 2 * y * y) + 2 * 0.001 * x * y;
    // Its pixel coordinates begin at the corner of the top-left pixel, ours at its centre.
    const double u = 320 + 7.5 + xd * 500 + xd * 2.5 - 0.5, v = 240 - 3.25 + yd * 500 - 0.5;
    const Eigen::Vector2d pixel = to_pixel(camera.pinhole, distort(camera.distortion, {x, y}));
    CHECK(pixel.x() == Approx(u).margin(1e-9));
    CHECK(pixel.y() == Approx(v).margin(1e-9));
  }
  const auto refuse = [](const std::string& key) {
    return refusal("a.xml",
                   "<calibration><projection>frame</projection><width>640</width><height>480</height>"
                   "<f>500</f>" +
                       key + "</calibration>");
  };
  CHECK_THAT(refuse("<k4>0.1</k4>"), Catch::Contains("k4"));
  CHECK_THAT(refuse("<p3>0.1</p3>"), Catch::Contains("p3"));
  CHECK_THAT(refuse("<b2>0.1</b2>"), Catch::Contains("b2"));
  CHECK_THAT(refusal("a.xml",
                     "<calibration><projection>equisolid_fisheye</projection><width>640</width>"
                     "<height>480</height><f>500</f></calibration>"),
             Catch::Contains("projection: is equisolid_fisheye"));
}

TEST_CASE("KITTI odometry says no size; KITTI-360's perspective cameras are KITTI's") {
  const std::string odometry = "P0: 718.9 0 607.2 0 0 718.9 185.2 0 0 0 1 0\nTr: 1 0 0 0 0 1 0 0 0 0 1 0\n";
  CHECK_THAT(refusal("calib.txt", odometry), Catch::Contains("P0: the file does not say the pictures' size"));
  check_camera(only_camera_of("calib.txt", odometry, {1241, 376}), {1241, 376, 718.9, 718.9, 607.2, 185.2},
               {});
  check_camera(
      only_camera_of("perspective.txt",
                     "calib_time: none\ncorner_dist: 0.1\nS_00: 640 480\nK_00: 500 0 318.25 0 501 241.75 "
                     "0 0 1\nD_00: -0.3 0.1 0.001 -0.002 0\nP_rect_00: 1 0 0 0 0 1 0 0 0 0 1 0\n"),
      foreign_pinhole, lens);
}
