#include <fmt/format.h>

#include "dataset/exchange/formats.h"

/// The file of OpenCV's calibration sample, as cv::FileStorage writes it: YAML or XML.
namespace cps {
namespace {

std::vector<double> matrix_data(const JsonKeys& root, const std::string& key) {
  const JsonKeys matrix = root.object(key);
  const std::size_t count = matrix.at("data").size();
  if (matrix.number("rows") * matrix.number("cols") != static_cast<double>(count))
    root.fail(key, "rows and cols do not agree with its data");
  return matrix.numbers("data", count);
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

Cameras read_opencv(const JsonKeys& root, const std::string& name) {
  const Pinhole camera = pinhole_from_k(matrix_data(root, "camera_matrix"), root.pixels("image_width"),
                                        root.pixels("image_height"), root.file + ": camera_matrix");
  const std::vector<double> coefficients = matrix_data(root, "distortion_coefficients");
  if (coefficients.size() < 4) root.fail("distortion_coefficients", "must be at least 4 numbers");
  return {{name, camera, from_opencv_order(coefficients, root.file + ": distortion_coefficients")}};
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
