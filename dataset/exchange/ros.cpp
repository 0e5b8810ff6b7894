#include <fmt/format.h>

#include "dataset/exchange/formats.h"

/// ROS camera_info YAML, as camera_calibration_parsers reads it, distortion model plumb_bob.
namespace cps {

Cameras read_ros(const JsonKeys& root, const std::string& name) {
  const std::string model = root.text("distortion_model");
  if (model != "plumb_bob" && model != "rational_polynomial")
    root.fail("distortion_model", "is " + model + "; only plumb_bob is supported");
  const Pinhole camera =
      pinhole_from_k(root.object("camera_matrix").numbers("data", 9), root.pixels("image_width"),
                     root.pixels("image_height"), root.file + ": camera_matrix");
  const JsonKeys distortion = root.object("distortion_coefficients");
  const std::vector<double> coefficients = distortion.numbers("data", distortion.at("data").size());
  return {{root.json.contains("camera_name") ? root.text("camera_name") : name, camera,
           from_opencv_order(coefficients, root.file + ": distortion_coefficients")}};
}

std::string write_ros(CameraSpan cameras) {
  const CalibratedCamera& camera = only_camera(cameras);
  const Pinhole& pinhole = camera.pinhole;
  const std::vector<double> projection = {pinhole.fx, 0, pinhole.cx, 0, 0, pinhole.fy,
                                          pinhole.cy, 0, 0,          0, 1, 0};
  const std::vector<double> unrectified = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto matrix = [](const char* name, int rows, int columns, std::span<const double> data) {
    return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: [{}]\n", name, rows, columns,
                       decimals(data, ", "));
  };
  return fmt::format("image_width: {}\nimage_height: {}\ncamera_name: {}\n", pinhole.width, pinhole.height,
                     nlohmann::json(camera.name).dump()) +
         matrix("camera_matrix", 3, 3, k_matrix(pinhole)) + "distortion_model: plumb_bob\n" +
         matrix("distortion_coefficients", 1, 5, in_opencv_order(camera.distortion)) +
         matrix("rectification_matrix", 3, 3, unrectified) + matrix("projection_matrix", 3, 4, projection);
}

}  // namespace cps
