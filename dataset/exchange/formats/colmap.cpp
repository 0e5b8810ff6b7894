#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "dataset/exchange/formats/formats.h"
#include "dataset/exchange/markup.h"

/// COLMAP's cameras.txt: CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]. Parameters are f or fx fy, then cx cy, then
/// coefficients. The centre of the top-left pixel is (.5, .5).
namespace cps {
namespace {

struct Model {
  const char* name;
  bool has_fy;
  std::size_t coefficients;
  NamedLens lens;
};
constexpr std::array<Model, 11> models{{{"SIMPLE_PINHOLE", false, 0, NamedLens::plane},
                                        {"PINHOLE", true, 0, NamedLens::plane},
                                        {"SIMPLE_RADIAL", false, 1, NamedLens::plane},
                                        {"RADIAL", false, 2, NamedLens::plane},
                                        {"OPENCV", true, 4, NamedLens::plane},
                                        {"FULL_OPENCV", true, 8, NamedLens::plane},
                                        {"SIMPLE_FISHEYE", false, 0, NamedLens::kannala_brandt},
                                        {"SIMPLE_RADIAL_FISHEYE", false, 1, NamedLens::kannala_brandt},
                                        {"RADIAL_FISHEYE", false, 2, NamedLens::kannala_brandt},
                                        {"OPENCV_FISHEYE", true, 4, NamedLens::kannala_brandt},
                                        {"EUCM", true, 2, NamedLens::eucm}}};

LensModel read_lens(NamedLens named, std::span<const double> coefficients, const std::string& where) {
  if (named == NamedLens::eucm) return Eucm{.alpha = coefficients[0], .beta = coefficients[1]};
  if (named == NamedLens::plane) return plane_lens(coefficients, where);
  std::vector<double> all(coefficients.begin(), coefficients.end());
  all.resize(4);
  return kannala_brandt_lens(all, where);
}

ModelCamera read_line(const std::string& line, const std::string& where) {
  std::istringstream words(line);
  std::string id, model_name, word;
  words >> id >> model_name;
  const auto model =
      std::find_if(models.begin(), models.end(), [&](const Model& m) { return m.name == model_name; });
  if (model == models.end())
    throw std::runtime_error(
        where + ": MODEL " + model_name +
        " is not supported: use OPENCV, FULL_OPENCV, OPENCV_FISHEYE, EUCM or a simpler one");
  std::vector<double> values;
  while (words >> word) {
    const nlohmann::json value = scalar(word);
    if (!value.is_number()) throw std::runtime_error(where + ": '" + word + "' is not a number");
    values.push_back(value);
  }
  const std::size_t focal_count = model->has_fy ? 2 : 1;
  if (values.size() != 2 + focal_count + 2 + model->coefficients)
    throw std::runtime_error(where + ": " + model_name + " needs a size and " +
                             std::to_string(focal_count + 2 + model->coefficients) + " parameters");
  const std::span<const double> after_focal = std::span(values).subspan(2 + focal_count);
  return {id,
          {.width = size_px(values[0], where + ": WIDTH"),
           .height = size_px(values[1], where + ": HEIGHT"),
           .fx = values[2],
           .fy = values[1 + focal_count],
           .cx = after_focal[0] - 0.5,
           .cy = after_focal[1] - 0.5},
          read_lens(model->lens, after_focal.subspan(2), where)};
}

bool is_id(const std::string& name) {
  return !name.empty() && name.size() < 10 && name.find_first_not_of("0123456789") == std::string::npos;
}

struct NamedCoefficients {
  const char* model;
  std::vector<double> values;
};

NamedCoefficients named_coefficients(const LensModel& lens) {
  if (const auto* eucm = std::get_if<Eucm>(&lens)) return {"EUCM", {eucm->alpha, eucm->beta}};
  std::vector<double> coefficients = opencv_coefficients(lens);
  if (std::holds_alternative<KannalaBrandt>(lens)) return {"OPENCV_FISHEYE", coefficients};
  const auto* brown_conrady = std::get_if<Distortion>(&lens);
  const bool is_opencv = brown_conrady != nullptr && brown_conrady->k3 == 0;
  coefficients.resize(is_opencv ? 4 : 8);
  return {is_opencv ? "OPENCV" : "FULL_OPENCV", coefficients};
}

}  // namespace

ModelCalibrationFile read_colmap(const std::string& text, const std::string& file) {
  ModelCalibrationFile result;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    std::string id;
    std::istringstream(line) >> id;
    for (const ModelCamera& camera : result.cameras)
      if (camera.name == id)
        throw std::runtime_error(file + ": line " + std::to_string(number) + ": CAMERA_ID " + id +
                                 " appears twice");
    add_camera(result, id, [&] { return read_line(line, file + ": line " + std::to_string(number)); });
  }
  return result;
}

std::string write_colmap(CameraSpan cameras) {
  // COLMAP requires whole numbers as camera ids.
  const bool keep_names =
      std::all_of(cameras.begin(), cameras.end(), [](const auto& camera) { return is_id(camera.name); });
  std::string text = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  int number = 0;
  for (const ModelCamera& camera : cameras) {
    const Pinhole& pinhole = camera.pinhole;
    std::vector<double> values = {pinhole.fx, pinhole.fy, pinhole.cx + 0.5, pinhole.cy + 0.5};
    const auto [model, coefficients] = named_coefficients(camera.lens);
    values.insert(values.end(), coefficients.begin(), coefficients.end());
    ++number;
    text += fmt::format("{} {} {} {} {}\n", keep_names ? camera.name : std::to_string(number), model,
                        pinhole.width, pinhole.height, decimals(values, " "));
  }
  return text;
}

}  // namespace cps
