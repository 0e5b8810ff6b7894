#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "dataset/exchange/formats/formats.h"

/// What OpenCV's calibration samples write through cv::FileStorage, YAML or XML: those of calib3d, of its
/// fisheye module (`fisheye_model: 1`, k1 k2 k3 k4) and of ccalib's omnidir module (`xi`, k1 k2 p1 p2).
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

/// ξ as a number, a list or a matrix of one; 0 without the key.
double xi_of(const JsonKeys& root) {
  if (!root.json.contains("xi")) return 0;
  if (root.json.at("xi").is_number()) return root.number("xi");
  const std::vector<double> values = matrix_numbers(root, "xi");
  if (values.size() != 1) root.fail("xi", "must be one number");
  return values[0];
}

LensModel read_lens(const JsonKeys& root, std::span<const double> coefficients, const std::string& where) {
  using enum NamedLens;
  const NamedLens named = named_lens(root, {plane, kannala_brandt, unified_spherical});
  if (named == kannala_brandt) {
    refuse_other_coefficients(root, {});
    return kannala_brandt_lens(coefficients, where);
  }
  refuse_other_coefficients(root, {"xi"});
  const double xi = xi_of(root);
  if (named == unified_spherical && !root.json.contains("xi"))
    root.fail("xi", "is missing, which the omnidirectional model needs");
  if (named == unified_spherical || xi != 0) return unified_spherical_lens(xi, coefficients, where);
  if (coefficients.size() < 4) throw std::runtime_error(where + ": must be at least 4 numbers");
  return plane_lens(coefficients, where);
}

/// What names the lens model where the coefficients alone do not, as `key: value`.
std::vector<std::pair<std::string, std::string>> naming_keys(const LensModel& lens) {
  if (std::holds_alternative<KannalaBrandt>(lens)) return {{"fisheye_model", "1"}};
  if (const auto* sphere = std::get_if<UnifiedSpherical>(&lens))
    return {{"camera_model", "omnidir"}, {"xi", decimal(sphere->xi)}};
  return {};
}

}  // namespace

bool is_opencv(const nlohmann::json& json) {
  return !key_like(json, matrix_names).empty();
}

ModelCamera read_opencv(const JsonKeys& root, const std::string& name) {
  const std::string matrix = key_like(root.json, matrix_names);
  const std::string found = key_like(root.json, coefficient_names);
  const std::string coefficients_key = found.empty() ? "distortion_coefficients" : found;
  const auto [width, height] = image_size(root);
  const Pinhole camera =
      pinhole_from_k(matrix_numbers(root, matrix), width, height, root.file + ": " + matrix);
  const std::vector<double> coefficients = matrix_numbers(root, coefficients_key);
  return {name, camera, read_lens(root, coefficients, root.file + ": " + coefficients_key)};
}

std::string write_opencv_yaml(CameraSpan cameras) {
  const ModelCamera& camera = only_camera(cameras);
  const std::vector<double> coefficients = opencv_coefficients(camera.lens);
  std::string text = fmt::format("%YAML:1.0\n---\nimage_width: {}\nimage_height: {}\n", camera.pinhole.width,
                                 camera.pinhole.height);
  for (const auto& [key, value] : naming_keys(camera.lens)) text += fmt::format("{}: {}\n", key, value);
  return text + yaml_matrix("camera_matrix", 3, 3, k_matrix(camera.pinhole)) +
         yaml_matrix("distortion_coefficients", static_cast<int>(coefficients.size()), 1, coefficients);
}

std::string write_opencv_xml(CameraSpan cameras) {
  const ModelCamera& camera = only_camera(cameras);
  const std::vector<double> coefficients = opencv_coefficients(camera.lens);
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>{}</image_width>\n"
      "<image_height>{}</image_height>\n",
      camera.pinhole.width, camera.pinhole.height);
  for (const auto& [key, value] : naming_keys(camera.lens))
    text += fmt::format("<{0}>{1}</{0}>\n", key, value);
  return text + xml_matrix("camera_matrix", 3, 3, k_matrix(camera.pinhole)) +
         xml_matrix("distortion_coefficients", static_cast<int>(coefficients.size()), 1, coefficients) +
         "</opencv_storage>\n";
}

}  // namespace cps
