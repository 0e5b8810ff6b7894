#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dataset/exchange/formats/formats.h"

/// What OpenCV's calibration sample writes through cv::FileStorage, YAML or XML.
namespace cps {
namespace {

/// The first key of the object that is one of `names` but for case and separators; empty if there is none.
std::string key_like(const nlohmann::json& json, std::initializer_list<const char*> names) {
  for (const auto& [key, value] : json.items())
    if (std::find(names.begin(), names.end(), plain_key(key)) != names.end()) return key;
  return {};
}

constexpr std::initializer_list<const char*> matrix_names{"cameramatrix", "mtx", "intrinsicmatrix"};
constexpr std::initializer_list<const char*> coefficient_names{
    "distortioncoefficients", "distortioncoeffs", "distcoeffs", "distcoeff", "distortion", "dist"};

/// cv::Mat's {rows, cols, data}, or nested lists.
std::vector<double> matrix_numbers(const JsonKeys& root, const std::string& key) {
  const nlohmann::json& value = root.at(key);
  if (!value.is_object()) return number_list(value, root.file + ": " + key);
  const std::string where = root.file + ": " + key + ": data";
  const JsonKeys matrix{value, root.file};
  if (!value.contains("data")) root.fail(key, "data: is missing");
  const std::vector<double> numbers = number_list(matrix.at("data"), where);
  if (matrix.number("rows") * matrix.number("cols") != static_cast<double>(numbers.size()))
    root.fail(key, "rows and cols do not agree with its data");
  return numbers;
}

/// Width and height, as two keys or as one list.
std::array<int, 2> image_size(const JsonKeys& root) {
  const std::string width = key_like(root.json, {"imagewidth", "width"}),
                    height = key_like(root.json, {"imageheight", "height"}),
                    both = key_like(root.json, {"imagesize", "imgsize", "resolution"});
  if (!both.empty() && width.empty()) {
    const std::string where = root.file + ": " + both;
    const std::vector<double> size = number_list(root.at(both), 2, where);
    return {size_px(size[0], where), size_px(size[1], where)};
  }
  const auto side = [&](const std::string& key, const char* usual) {
    return size_px(root.number(key.empty() ? usual : key), root.file + ": " + key);
  };
  return {side(width, "image_width"), side(height, "image_height")};
}

std::string yaml_matrix(const std::string& name, int rows, int columns, std::span<const double> data) {
  return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: [ {} ]\n", name, rows,
                     columns, decimals(data, ", "));
}

std::string xml_matrix(const std::string& name, int rows, int columns, std::span<const double> data) {
  return fmt::format(
      "<{0} type_id=\"opencv-matrix\">\n  <rows>{1}</rows>\n  <cols>{2}</cols>\n  <dt>d</dt>\n  "
      "<data>\n    {3}</data></{0}>\n",
      name, rows, columns, decimals(data, " "));
}

}  // namespace

bool is_opencv(const nlohmann::json& json) {
  return !key_like(json, matrix_names).empty();
}

CalibratedCamera read_opencv(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {});
  const std::string matrix = key_like(root.json, matrix_names);
  const std::string found = key_like(root.json, coefficient_names);
  const std::string coefficients_key = found.empty() ? "distortion_coefficients" : found;
  const auto [width, height] = image_size(root);
  const Pinhole camera =
      pinhole_from_k(matrix_numbers(root, matrix), width, height, root.file + ": " + matrix);
  const std::vector<double> coefficients = matrix_numbers(root, coefficients_key);
  if (coefficients.size() < 4) root.fail(coefficients_key, "must be at least 4 numbers");
  return {name, camera, from_opencv_order(coefficients, root.file + ": " + coefficients_key)};
}

std::string write_opencv_yaml(CameraSpan cameras) {
  const CalibratedCamera& camera = only_camera(cameras);
  return fmt::format("%YAML:1.0\n---\nimage_width: {}\nimage_height: {}\n", camera.pinhole.width,
                     camera.pinhole.height) +
         yaml_matrix("camera_matrix", 3, 3, k_matrix(camera.pinhole)) +
         yaml_matrix("distortion_coefficients", 5, 1, in_opencv_order(camera.distortion));
}

std::string write_opencv_xml(CameraSpan cameras) {
  const CalibratedCamera& camera = only_camera(cameras);
  return fmt::format(
             "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>{}</image_width>\n"
             "<image_height>{}</image_height>\n",
             camera.pinhole.width, camera.pinhole.height) +
         xml_matrix("camera_matrix", 3, 3, k_matrix(camera.pinhole)) +
         xml_matrix("distortion_coefficients", 5, 1, in_opencv_order(camera.distortion)) +
         "</opencv_storage>\n";
}

}  // namespace cps
