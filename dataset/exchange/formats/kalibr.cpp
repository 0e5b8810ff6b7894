#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "dataset/exchange/formats/formats.h"

/// Kalibr's camchain YAML. Intrinsics and distortion_coeffs of its models: pinhole [fu fv pu pv] with radtan
/// [k1 k2 p1 p2], equidistant [k1 k2 k3 k4] or none; omni [xi fu fv pu pv] with radtan or none; ds [xi alpha
/// fu fv pu pv] and eucm [alpha beta fu fv pu pv] with none.
namespace cps {
namespace {

/// Kalibr's name of a camera model, and the parameters that stand before the focal lengths.
struct CameraModel {
  std::string name;
  std::vector<double> before_focal = {};
};

CameraModel camera_model(const LensModel& lens) {
  if (const auto* sphere = std::get_if<UnifiedSpherical>(&lens)) return {"omni", {sphere->xi}};
  if (const auto* spheres = std::get_if<DoubleSphere>(&lens)) return {"ds", {spheres->xi, spheres->alpha}};
  if (const auto* eucm = std::get_if<Eucm>(&lens)) return {"eucm", {eucm->alpha, eucm->beta}};
  return {"pinhole"};
}

LensModel read_lens(const std::string& camera, const std::string& distortion,
                    std::span<const double> before_focal, std::span<const double> coefficients,
                    const JsonKeys& keys) {
  const std::string where = keys.file + ": distortion_coeffs";
  const bool is_radtan = distortion == "radtan", is_none = distortion == "none";
  if (is_none && !std::all_of(coefficients.begin(), coefficients.end(), [](double k) { return k == 0; }))
    throw std::runtime_error(where + ": is not 0, though distortion_model is none");
  if (is_radtan && coefficients.size() != 4) throw std::runtime_error(where + ": must be 4 numbers");
  const Distortion radtan = is_radtan ? brown_conrady_lens(coefficients, where) : Distortion{};
  if (camera == "pinhole" && (is_radtan || is_none)) return radtan;
  if (camera == "pinhole" && (distortion == "equidistant" || distortion == "equi"))
    return kannala_brandt_lens(coefficients, where);
  if (camera == "omni" && (is_radtan || is_none))
    return UnifiedSpherical{.xi = before_focal[0], .distortion = radtan};
  if (camera == "ds" && is_none) return DoubleSphere{.xi = before_focal[0], .alpha = before_focal[1]};
  if (camera == "eucm" && is_none) return Eucm{.alpha = before_focal[0], .beta = before_focal[1]};
  keys.fail(
      "distortion_model",
      "is " + distortion + ", which cps does not read with camera_model " + camera +
          ": calibrate with pinhole-radtan, pinhole-equi, omni-radtan, omni-none, ds-none or eucm-none");
}

ModelCamera read_kalibr_camera(const JsonKeys& keys, const std::string& name) {
  using enum NamedLens;
  const NamedLens named = named_lens(keys, {plane, kannala_brandt, unified_spherical, eucm, double_sphere});
  refuse_other_coefficients(keys, {});
  const std::string camera = keys.text("camera_model"), distortion = keys.text("distortion_model");
  if (camera == "pinhole" && named != plane && distortion != "equidistant" && distortion != "equi")
    keys.fail("distortion_model",
              "is " + distortion + ", but another key names another lens model: keep one");
  std::size_t before_focal = 0;
  if (camera == "omni")
    before_focal = 1;
  else if (camera == "ds" || camera == "eucm")
    before_focal = 2;
  else if (camera != "pinhole")
    keys.fail("camera_model", "is " + camera + "; must be pinhole, omni, ds or eucm");
  const auto list = [&](const char* key, std::size_t count) {
    return number_list(keys.at(key), count, keys.file + ": " + key);
  };
  const std::vector<double> intrinsics = list("intrinsics", before_focal + 4), size = list("resolution", 2);
  std::vector<double> coefficients;
  if (distortion != "none" || keys.json.contains("distortion_coeffs"))
    coefficients = number_list(keys.at("distortion_coeffs"), keys.file + ": distortion_coeffs");
  const std::span<const double> before = std::span(intrinsics).first(before_focal),
                                focal = std::span(intrinsics).subspan(before_focal);
  const std::string where = keys.file + ": resolution";
  return {name,
          {.width = size_px(size[0], where),
           .height = size_px(size[1], where),
           .fx = focal[0],
           .fy = focal[1],
           .cx = focal[2],
           .cy = focal[3]},
          read_lens(camera, distortion, before, coefficients, keys)};
}

}  // namespace

ModelCalibrationFile read_kalibr(const JsonKeys& root) {
  ModelCalibrationFile file;
  for (const auto& [name, value] : root.json.items()) {
    if (!value.is_object()) continue;  // notes beside the cameras
    const std::string where = root.file + ": " + name;
    add_camera(file, name, [&] { return read_kalibr_camera(JsonKeys{value, where}, name); });
  }
  return file;
}

std::string write_kalibr(CameraSpan cameras) {
  std::string text;
  int index = 0;
  for (const ModelCamera& camera : cameras) {
    const Pinhole& pinhole = camera.pinhole;
    auto [name, intrinsics] = camera_model(camera.lens);
    intrinsics.insert(intrinsics.end(), {pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy});
    std::vector<double> coefficients = opencv_coefficients(camera.lens);
    const char* distortion = "radtan";
    if (std::holds_alternative<KannalaBrandt>(camera.lens)) distortion = "equidistant";
    if (coefficients.empty()) distortion = "none";
    coefficients.resize(std::min<std::size_t>(4, coefficients.size()));  // radtan has no k3
    // Kalibr looks for cam0, cam1, …
    text += fmt::format("cam{}:\n  camera_model: {}\n  distortion_coeffs: [{}]\n", index++, name,
                        decimals(coefficients, ", "));
    text += fmt::format("  distortion_model: {}\n  intrinsics: [{}]\n  resolution: [{}, {}]\n", distortion,
                        decimals(intrinsics, ", "), pinhole.width, pinhole.height);
  }
  return text;
}

}  // namespace cps
