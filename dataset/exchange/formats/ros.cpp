#include <fmt/format.h>

#include "dataset/exchange/formats/formats.h"

namespace cps {
namespace {

void check_model(const JsonKeys& root) {
  const std::string model = root.text("distortion_model");
  if (model != "plumb_bob" && model != "rational_polynomial" && !model.empty())
    root.fail("distortion_model", "is " + model + "; only plumb_bob is supported");
}

/// A message may be of a part of the sensor, or of every second pixel: then K is not that of the pictures.
void refuse_parts(const JsonKeys& root) {
  for (const char* key : {"binning_x", "binning_y"})
    if (root.json.contains(key) && root.number(key) > 1)
      root.fail(key, "is more than 1: give the camera_info of the pictures themselves");
  if (!root.json.contains("roi")) return;
  const JsonKeys roi = root.object("roi");
  for (const char* key : {"x_offset", "y_offset", "width", "height"})
    if (roi.json.is_object() && roi.json.contains(key) && roi.number(key) != 0)
      root.fail("roi", std::string(key) + " is not 0: give the camera_info of the whole picture");
}

}  // namespace

CalibratedCamera read_ros(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {"distortion_model"});
  check_model(root);
  const auto data = [&](const char* key) {
    const JsonKeys matrix = root.object(key);
    if (!matrix.json.is_object() || !matrix.json.contains("data")) root.fail(key, "data: is missing");
    return number_list(matrix.at("data"), root.file + ": " + key + ": data");
  };
  const Pinhole camera = pinhole_from_k(data("camera_matrix"), root.pixels("image_width"),
                                        root.pixels("image_height"), root.file + ": camera_matrix");
  return {root.json.contains("camera_name") ? name_at(root, "camera_name") : name, camera,
          from_opencv_order(data("distortion_coefficients"), root.file + ": distortion_coefficients")};
}

CalibratedCamera read_ros_message(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {"distortion_model"});
  check_model(root);
  refuse_parts(root);
  const bool is_ros1 = root.json.contains("K");  // ROS 2 writes k, d
  const std::string k = is_ros1 ? "K" : "k", d = is_ros1 ? "D" : "d";
  const Pinhole camera = pinhole_from_k(number_list(root.at(k), 9, root.file + ": " + k),
                                        root.pixels("width"), root.pixels("height"), root.file + ": " + k);
  return {name, camera,
          from_opencv_order(number_list(root.at(d), root.file + ": " + d), root.file + ": " + d)};
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
