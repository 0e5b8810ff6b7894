#include "dataset/exchange/camera_json.h"

#include <map>
#include <stdexcept>

#include "dataset/exchange/formats/formats.h"
#include "numbers/angles.h"

namespace cps {

nlohmann::ordered_json camera_json(const Pinhole& camera, const Distortion& lens) {
  const std::vector<std::vector<double>> k = {
      {camera.fx, 0, camera.cx}, {0, camera.fy, camera.cy}, {0, 0, 1}};
  return {{"fov", degrees(hfov_rad(camera))},
          {"K", k},
          {"width", camera.width},
          {"height", camera.height},
          {"k1", lens.k1},
          {"k2", lens.k2},
          {"k3", lens.k3},
          {"p1", lens.p1},
          {"p2", lens.p2},
          {"cx", camera.cx},
          {"cy", camera.cy}};
}

nlohmann::ordered_json rows_json(const Eigen::MatrixX4d& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& row : rows.rowwise()) json.push_back({row[0], row[1], row[2], row[3]});
  return json;
}

CalibratedCamera camera_from_json(const JsonKeys& keys) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> k = keys.matrix("K", 3, 3);
  return {.name = {},
          .pinhole =
              pinhole_from_k({k.data(), 9}, keys.pixels("width"), keys.pixels("height"), keys.file + ": K"),
          .distortion = {.k1 = keys.number("k1"),
                         .k2 = keys.number("k2"),
                         .k3 = keys.number("k3"),
                         .p1 = keys.number("p1"),
                         .p2 = keys.number("p2")}};
}

nlohmann::ordered_json model_camera_json(const Pinhole& camera, const LensModel& lens) {
  if (const auto* brown_conrady = std::get_if<Distortion>(&lens)) return camera_json(camera, *brown_conrady);
  nlohmann::ordered_json params;
  for (const auto& [name, value] : parameters(lens)) params[std::string(name)] = value;
  const std::vector<std::vector<double>> k = {
      {camera.fx, 0, camera.cx}, {0, camera.fy, camera.cy}, {0, 0, 1}};
  return {{"model", std::string(family_name(lens))},
          {"params", params},
          {"K", k},
          {"width", camera.width},
          {"height", camera.height}};
}

ModelCamera model_camera_from_json(const JsonKeys& keys) {
  if (!keys.json.contains("params")) {
    if (keys.json.contains("model") &&
        lens_of_name(keys.text("model"), keys.file + ": model").value_or(NamedLens::plane) !=
            NamedLens::plane)
      keys.fail("params", "is missing: give the parameters of " + keys.text("model"));
    refuse_other_coefficients(keys, {"k1", "k2", "k3", "p1", "p2"});
    return model_camera(camera_from_json(keys));
  }
  refuse_other_coefficients(keys, {});
  const std::string family = keys.text("model");
  const JsonKeys params{keys.at("params"), keys.file};
  if (!params.json.is_object()) keys.fail("params", "must name the parameters: {\"k1\": …}");
  std::map<std::string, double> values;
  for (const auto& [name, value] : params.json.items()) values[name] = params.number(name);
  LensModel lens;
  try {
    lens = lens_from_parameters(family, values);
  } catch (const std::runtime_error& error) {
    keys.fail("model, params", error.what());
  }
  for (const auto& [name, value] : parameters(lens))
    if (!values.contains(std::string(name)))
      keys.fail("params", std::string(name) + " is missing: give all parameters of " + family);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> k = keys.matrix("K", 3, 3);
  return {{},
          pinhole_from_k({k.data(), 9}, keys.pixels("width"), keys.pixels("height"), keys.file + ": K"),
          lens};
}

}  // namespace cps
