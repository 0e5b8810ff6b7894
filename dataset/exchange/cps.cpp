#include "dataset/exchange/formats.h"

/// Our own calibration.json, of which only the keys that describe the camera are read: published CPS datasets
/// have no others.
namespace cps {

Cameras read_cps(const JsonKeys& root, const std::string& name) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> k = root.matrix("K", 3, 3);
  const Pinhole camera =
      pinhole_from_k({k.data(), 9}, root.pixels("width"), root.pixels("height"), root.file + ": K");
  const Distortion lens{.k1 = root.number("k1"),
                        .k2 = root.number("k2"),
                        .k3 = root.number("k3"),
                        .p1 = root.number("p1"),
                        .p2 = root.number("p2")};
  const bool is_named = root.json.contains("camera") && root.at("camera").contains("name");
  return {{is_named ? root.object("camera").text("name") : name, camera, lens}};
}

std::string write_cps(CameraSpan cameras) {
  const CalibratedCamera& camera = only_camera(cameras);
  const Pinhole& pinhole = camera.camera;
  const Distortion& lens = camera.distortion;
  const std::vector<std::vector<double>> k = {
      {pinhole.fx, 0, pinhole.cx}, {0, pinhole.fy, pinhole.cy}, {0, 0, 1}};
  const nlohmann::ordered_json json = {{"fov", degrees(hfov_rad(pinhole))},
                                       {"K", k},
                                       {"width", pinhole.width},
                                       {"height", pinhole.height},
                                       {"k1", lens.k1},
                                       {"k2", lens.k2},
                                       {"k3", lens.k3},
                                       {"p1", lens.p1},
                                       {"p2", lens.p2},
                                       {"cx", pinhole.cx},
                                       {"cy", pinhole.cy},
                                       {"camera", {{"name", camera.name}}}};
  return json.dump(2) + "\n";
}

}  // namespace cps
