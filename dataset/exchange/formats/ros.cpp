#include <fmt/format.h>

#include "dataset/exchange/formats/formats.h"

/// ROS' camera_info: plumb_bob (k1 k2 p1 p2 k3), rational_polynomial (… k4 k5 k6), equidistant, by some
/// called fisheye (k1 k2 k3 k4).

namespace cps {
namespace {

LensModel read_lens(const JsonKeys& root, std::span<const double> coefficients, const std::string& where) {
  const NamedLens named = named_lens(root, {NamedLens::plane, NamedLens::kannala_brandt});
  refuse_other_coefficients(root, {});
  const std::string model = root.text("distortion_model");
  if (model == "equidistant" || model == "fisheye") return kannala_brandt_lens(coefficients, where);
  if (named == NamedLens::kannala_brandt)
    root.fail("distortion_model", "names no fisheye, but another key does: keep one of them");
  if (model == "rational_polynomial") return plane_lens(coefficients, where);
  if (model == "plumb_bob" || model.empty()) return brown_conrady_lens(coefficients, where);
  root.fail("distortion_model", "is " + model + "; must be plumb_bob, rational_polynomial or equidistant");
}

const char* model_name(const LensModel& lens) {
  if (std::holds_alternative<RationalLens>(lens)) return "rational_polynomial";
  return std::holds_alternative<KannalaBrandt>(lens) ? "equidistant" : "plumb_bob";
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

ModelCamera read_ros(const JsonKeys& root, const std::string& name) {
  const auto data = [&](const char* key) {
    const JsonKeys matrix = root.object(key);
    if (!matrix.json.is_object() || !matrix.json.contains("data")) root.fail(key, "data: is missing");
    return number_list(matrix.at("data"), root.file + ": " + key + ": data");
  };
  const Pinhole camera = pinhole_from_k(data("camera_matrix"), root.pixels("image_width"),
                                        root.pixels("image_height"), root.file + ": camera_matrix");
  return {root.json.contains("camera_name") ? name_at(root, "camera_name") : name, camera,
          read_lens(root, data("distortion_coefficients"), root.file + ": distortion_coefficients")};
}

ModelCamera read_ros_message(const JsonKeys& root, const std::string& name) {
  refuse_parts(root);
  const bool is_ros1 = root.json.contains("K");  // ROS 2 writes k, d
  const std::string k = is_ros1 ? "K" : "k", d = is_ros1 ? "D" : "d";
  const Pinhole camera = pinhole_from_k(number_list(root.at(k), 9, root.file + ": " + k),
                                        root.pixels("width"), root.pixels("height"), root.file + ": " + k);
  return {name, camera, read_lens(root, number_list(root.at(d), root.file + ": " + d), root.file + ": " + d)};
}

std::string write_ros(CameraSpan cameras) {
  const ModelCamera& camera = only_camera(cameras);
  const std::vector<double> coefficients = opencv_coefficients(camera.lens);
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
         matrix("camera_matrix", 3, 3, k_matrix(pinhole)) + "distortion_model: " + model_name(camera.lens) +
         "\n" + matrix("distortion_coefficients", 1, static_cast<int>(coefficients.size()), coefficients) +
         matrix("rectification_matrix", 3, 3, unrectified) + matrix("projection_matrix", 3, 4, projection);
}

}  // namespace cps
