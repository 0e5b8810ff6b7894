#include "dataset/labels/label_check.h"

#include <fmt/format.h>

#include <cmath>

#include "distortion/certificate/certificate.h"
#include "distortion/crop/true_fov.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr int rim_samples = 4096;  ///< per edge of the master
constexpr int grid_samples = 24;   ///< per axis of the frame
constexpr double max_allowed_roundtrip_px = 1e-6;
constexpr double angle_tolerance_deg = 1e-6;

/// Signed distance in pixels from the frame's border to `pixel`: positive outside, in the maximum norm.
double outside_px(const Pinhole& camera, const Eigen::Vector2d& pixel) {
  return std::max({-0.5 - pixel.x(), pixel.x() - (camera.width - 0.5), -0.5 - pixel.y(),
                   pixel.y() - (camera.height - 0.5)});
}

double rim_margin_px(const Label& label, const Eigen::AlignedBox2d& master) {
  double margin = 1e30;
  for (int i = 0; i <= rim_samples; ++i) {
    const double t = static_cast<double>(i) / rim_samples;
    const Eigen::Vector2d along = master.min() + t * master.sizes();
    for (const Eigen::Vector2d& ideal :
         {Eigen::Vector2d(along.x(), master.min().y()), Eigen::Vector2d(along.x(), master.max().y()),
          Eigen::Vector2d(master.min().x(), along.y()), Eigen::Vector2d(master.max().x(), along.y())})
      margin = std::min(margin,
                        outside_px(label.camera, to_pixel(label.camera, distort(label.distortion, ideal))));
  }
  return margin;
}

double roundtrip_px(const Label& label, const Eigen::AlignedBox2d& master) {
  double worst = 0;
  for (int j = 0; j <= grid_samples; ++j)
    for (int i = 0; i <= grid_samples; ++i) {
      const Eigen::Vector2d pixel(-0.5 + label.camera.width * (static_cast<double>(i) / grid_samples),
                                  -0.5 + label.camera.height * (static_cast<double>(j) / grid_samples));
      const auto ideal = undistort(label.distortion, master, to_plane(label.camera, pixel));
      if (!ideal) return INFINITY;
      worst = std::max(worst, (to_pixel(label.camera, distort(label.distortion, *ideal)) - pixel).norm());
    }
  return worst;
}

}  // namespace

LabelCheck check_label(const Label& label) {
  LabelCheck check;
  const auto fault = [&](bool is_fault, const std::string& what) {
    if (is_fault) check.faults.push_back(what);
  };
  const Pinhole base = base_of(label);
  const Eigen::AlignedBox2d master = frame_on_plane(base);
  const Certificate certificate =
      certify(label.distortion, master, {.min_eigenvalue = 1e-3, .max_eigenvalue = 1e3});
  fault(!certificate.valid, "certificate: not one-to-one on the master: " + certificate.why);
  if (!certificate.valid) return check;
  fault(std::abs(certificate.min_eigenvalue - label.certificate_min_eigenvalue) > 2e-5,
        fmt::format("certificate: min_eigenvalue {} is claimed, {} found", label.certificate_min_eigenvalue,
                    certificate.min_eigenvalue));
  check.rim_margin_px = rim_margin_px(label, master);
  fault(check.rim_margin_px < -1e-6,
        fmt::format("crop: the master's rim lies {} px inside the frame", -check.rim_margin_px));
  check.max_roundtrip_px = roundtrip_px(label, master);
  fault(!(check.max_roundtrip_px <= max_allowed_roundtrip_px),
        fmt::format("certificate: round trip off by {} px", check.max_roundtrip_px));
  fault(std::abs(label.camera.fx / base.fx - label.zoom) > 1e-9 * label.zoom,
        "crop: zoom contradicts fov and fov_base_deg");
  const std::optional<TrueFov> true_angles = true_fov(label.distortion, label.camera, master);
  fault(!(true_angles &&
          std::abs(degrees(true_angles->horizontal_rad) - label.fov_true_h_deg) <= angle_tolerance_deg &&
          std::abs(degrees(true_angles->vertical_rad) - label.fov_true_v_deg) <= angle_tolerance_deg &&
          std::abs(degrees(true_angles->diagonal_rad) - label.fov_true_d_deg) <= angle_tolerance_deg),
        "fov_true_deg: contradicts lens and K");
  const Distortion& lens = label.distortion;
  const double values[] = {lens.k1, lens.k2, lens.k3, lens.p1, lens.p2, label.camera.cx, label.camera.cy};
  for (std::size_t i = 0; i < lens_keys.size(); ++i)
    fault(label.limits[i] && !(values[i] >= label.limits[i]->low && values[i] <= label.limits[i]->high),
          fmt::format("{}: {} lies outside its limits", lens_keys[i], values[i]));
  return check;
}

}  // namespace cps
