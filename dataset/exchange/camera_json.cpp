#include "dataset/exchange/camera_json.h"

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

}  // namespace cps
