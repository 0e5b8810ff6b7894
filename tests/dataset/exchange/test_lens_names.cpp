#include "tests/dataset/exchange/read_text.h"

using namespace cps;

namespace {

std::string opencv(const std::string& more) {
  return "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n" + more +
         "camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 501, 240, 0, 0, 1]}\n"
         "distortion_coefficients: {rows: 4, cols: 1, data: [-0.02, 0.01, 0.003, -0.001]}\n";
}

std::string cps_json(const std::string& more) {
  return R"({"K": [[500, 0, 320], [0, 501, 240], [0, 0, 1]], "width": 640, "height": 480, "k1": 0, "k2": 0,
             "k3": 0, "p1": 0, "p2": 0)" +
         more + "}";
}

}  // namespace

TEST_CASE("a key that names an unknown lens model is refused by name") {
  CHECK(refusal("a.yml", opencv("")) == "accepted");
  CHECK(refusal("a.yml", opencv("fisheye_model: 0\nflags: 4\navg_reprojection_error: 0.3\n")) == "accepted");
  CHECK_THAT(refusal("a.yml", opencv("camera_model: \"scaramuzza\"\n")),
             Catch::Contains("camera_model: is scaramuzza"));
  CHECK_THAT(refusal("a.yml", opencv("camera_model: eucm\n")), Catch::Contains("camera_model: is eucm"));
  CHECK_THAT(refusal("a.yml", opencv("fisheye_model: equisolid\n")),
             Catch::Contains("fisheye_model: is equisolid"));
  CHECK_THAT(refusal("a.yml", opencv("fisheye_parameters: {c: 1}\n")),
             Catch::Contains("fisheye_parameters: is given"));
  CHECK_THAT(refusal("a.yml", opencv("omnidir_flags: 3\n")), Catch::Contains("xi: is missing"));
  CHECK_THAT(refusal("a.yml", opencv("left_camera_model: scaramuzza\n")),
             Catch::Contains("left_camera_model: is scaramuzza"));
  CHECK(refusal("a.yml", opencv("sensor_type: camera\n")) == "accepted");
  CHECK_THAT(refusal("a.yml", opencv("s1: 0.1\n")), Catch::Contains("s1: is 0.1"));
  CHECK(refusal("a.json", cps_json("")) == "accepted");
  CHECK_THAT(refusal("a.json", cps_json(R"(, "k4": 0.1)")), Catch::Contains("k4: is 0.1"));
  CHECK_THAT(refusal("a.json", cps_json(R"(, "xi": 1)")), Catch::Contains("xi"));
  CHECK_THAT(refusal("a.json", cps_json(R"(, "model": "double_sphere")")), Catch::Contains("double_sphere"));
  CHECK_THAT(refusal("transforms.json",
                     R"({"fl_x": 500, "cx": 320, "cy": 240, "w": 640, "h": 480, "ftheta_p0": 0.1})"),
             Catch::Contains("ftheta_p0"));
  CHECK_THAT(
      refusal("camchain.yaml",
              "cam0: {camera_model: pinhole, distortion_model: radtan, xi: 1.1, intrinsics: [500, 500, 320, "
              "240], resolution: [640, 480], distortion_coeffs: [0, 0, 0, 0]}\n"),
      Catch::Contains("xi"));
}

TEST_CASE("keys that name two lens models are refused with both names") {
  CHECK_THAT(refusal("a.yml", opencv("camera_model: plumb_bob\nfisheye_model: 1\n")),
             Catch::Contains("fisheye_model: is 1, but camera_model names another lens model"));
  CHECK_THAT(refusal("a.yml", opencv("fisheye_model: 1\nxi: 1.2\n")), Catch::Contains("xi: is 1.2"));
  CHECK_THAT(refusal("a.yml", opencv("camera_model: omnidir\ndistortion_model: fisheye\nxi: 1.2\n")),
             Catch::Contains("camera_model: is omnidir"));
  const auto fisheye = read_model_calibration_file(file_of("a.yml", opencv("fisheye_camera_model: 1\n")));
  CHECK(std::holds_alternative<KannalaBrandt>(fisheye.cameras.at(0).lens));
  CHECK_THAT(refusal("transforms.json",
                     R"({"camera_model": "PINHOLE", "fl_x": 500, "cx": 320, "cy": 240, "w": 640, "h": 480,
                         "is_fisheye": true})"),
             Catch::Contains("camera_model: names no fisheye, but is_fisheye does"));
  CHECK_THAT(refusal("a.json", "{\"x\": " + std::string(200'000, '[') + std::string(200'000, ']') + "}"),
             Catch::Contains("nested too deeply"));
  CHECK_THAT(refusal("transforms.json",
                     R"({"camera_model": "OPENCV", "fl_x": 500, "cx": 320, "cy": 240, "w": 640, "h": 480,
                         "k1": 0.1, "is_fisheye": true})"),
             Catch::Contains("is_fisheye: is true, but camera_model names another lens model"));
  CHECK_THAT(refusal("a.json", cps_json(R"(, "fisheye_model": 1)")), Catch::Contains("model: is missing"));
}

TEST_CASE("a camera that cannot be read does not hide the others") {
  const std::filesystem::path kalibr = file_of(
      "camchain.yaml",
      "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [-0.3, 0.1, 0.001, -0.002]\n  distortion_model: "
      "radtan\n  intrinsics: [500, 501, 320, 240]\n  resolution: [640, 480]\ncam1:\n  camera_model: pinhole\n  "
      "distortion_coeffs: [0.9]\n  distortion_model: fov\n  intrinsics: [280, 280, "
      "424, 400]\n  resolution: [848, 800]\n");
  CHECK(read_camera(kalibr, "cam0").distortion.p2 == -0.002);
  CHECK_THROWS_WITH(read_camera(kalibr, "cam1"), Catch::Contains("fov"));
  CHECK_THROWS_WITH(read_camera(kalibr, ""), Catch::Contains("choose one of cam0 cam1"));
  CHECK_THROWS_WITH(read_calibration(kalibr), Catch::Contains("fov"));
  const std::filesystem::path colmap = file_of("cameras.txt",
                                               "1 OPENCV 640 480 500 501 320 240 -0.3 0.1 0.001 -0.002\n"
                                               "2 FOV 800 800 300 300 400 400 0.9\n");
  CHECK(read_camera(colmap, "1").distortion.k1 == -0.3);
  CHECK_THROWS_WITH(read_camera(colmap, "2"), Catch::Contains("MODEL FOV"));
}

TEST_CASE("numbers beyond any lens are refused, whatever the certificate would say of them") {
  const auto with_lens = [](const std::string& numbers) {
    return refusal("cameras.txt", "1 OPENCV 64 48 50 50 32 24 " + numbers + "\n");
  };
  CHECK_THAT(with_lens("0 0 1e308 -1e308"), Catch::Contains("p1: beyond any lens"));
  CHECK_THAT(with_lens("1e9 0 0 0"), Catch::Contains("k1: beyond any lens"));
  CHECK_THAT(refusal("cameras.txt", "1 SIMPLE_PINHOLE 64 48 1e-5 32 24\n"),
             Catch::Contains("fx, fy: beyond"));
  CHECK_THAT(refusal("cameras.txt", "1 SIMPLE_PINHOLE 64 48 1e30 32 24\n"),
             Catch::Contains("fx, fy: beyond"));
  // Raw coefficients grow without bound as the field of view narrows: a telephoto lens of 3 degrees.
  CHECK(refusal("cameras.txt",
                "1 FULL_OPENCV 1920 1080 36000 36000 960 540 200 30000 0 0 10000000 0 0 0\n") == "accepted");
}

TEST_CASE("text around the numbers: each oddity has one answer, which names field and mend") {
  // A byte order mark, Windows' line ends and comments are no part of the calibration.
  CHECK(refusal("cameras.txt",
                "\xEF\xBB\xBF# Camera list\r\n1 OPENCV 640 480 500 501 320 240 -0.3 0.1 0.001 0\r\n") ==
        "accepted");
  CHECK(refusal("a.yml", "# K_0 of the first run\n" + opencv("").substr(14)) == "accepted");
  CHECK_THAT(refusal("a.yml", std::string("\xFF\xFEk\0", 4)), Catch::Contains("UTF-16"));
  // A key that appears twice has two values; neither is chosen.
  CHECK_THAT(refusal("a.yml", opencv("image_width: 320\n")),
             Catch::Contains("line 5: the key 'image_width' appears twice"));
  CHECK_THAT(refusal("a.json", cps_json(R"(, "k1": 0.5)")), Catch::Contains("k1: appears twice"));
  CHECK_THAT(refusal("kitti.txt",
                     "S_00: 640 480\nK_00: 500 0 320 0 500 240 0 0 1\nD_00: 0 0 0 0 0\nD_00: .1 0 0 0 0\n"),
             Catch::Contains("D_00: appears twice"));
  // Lists without commas, decimal commas.
  const std::string ros =
      "image_width: 640\nimage_height: 480\ncamera_name: 14000000\ncamera_matrix: {rows: 3, cols: 3, data: [500, 0, "
      "320, 0, 501, 240, 0, 0, 1]}\ndistortion_model: plumb_bob\ndistortion_coefficients: {rows: 1, cols: 5, data: ";
  CHECK_THAT(refusal("a.yaml", ros + "[-0.3 0.1 0.001 -0.002 0]}\n"),
             Catch::Contains("distortion_coefficients: data: ") &&
                 Catch::Contains("separate the numbers by commas"));
  CHECK_THAT(refusal("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500,5 320 240\n"), Catch::Contains("500,5"));
  // Cameras are named by serial numbers, with leading zeros perhaps.
  CHECK(read_calibration(file_of("a.yaml", ros + "[0, 0, 0, 0, 0]}\n")).front().name == "14000000");
  CHECK(read_camera(file_of("a.yaml",
                            "camera_name: 007\n" + ros.substr(0, 35) + ros.substr(57) + "[0, 0, 0, 0, 0]}\n"),
                    "007")
            .pinhole.width == 640);
}

TEST_CASE("aliases expand to a bounded size") {
  std::string bomb = "a: &a [1,1,1,1,1,1,1,1,1]\n";
  for (char c = 'b'; c <= 'j'; ++c) {
    const std::string before(1, static_cast<char>(c - 1));
    bomb += std::string(1, c) + ": &" + c + " [";
    for (int i = 0; i < 9; ++i) bomb += (i ? ",*" : "*") + before;
    bomb += "]\n";
  }
  CHECK_THAT(refusal("bomb.yml", bomb), Catch::Contains("expands to too many values"));
}
