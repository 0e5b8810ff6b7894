#include <fmt/format.h>

#include <cmath>

#include "apps/lens/report.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/inverse/model_survey.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/model_view.h"
#include "numbers/angles.h"

namespace cps {
namespace {

std::string verdict(const ModelCertificate& proof, const ModelSurvey& survey) {
  if (proof.valid)
    return fmt::format("yes, proved: local scale {:.4f} to {:.4f} wherever the image looks", proof.min_scale,
                       proof.max_scale);
  const std::int64_t inside = survey.pixels - survey.outside;
  return fmt::format("no: proved for {} of {} pixels ({:.3f} %) only", inside, survey.pixels,
                     percent(inside, survey.pixels));
}

/// The label is that of a pinhole camera with the focal lengths that the picture has on the axis, where a
/// family's f may be multiplied by a factor (1 / (1 + ξ) on a sphere).
std::string angles(const ModelCamera& camera, const RayRegion& region) {
  const double factor = project(camera.lens, Eigen::Vector3d::UnitZ()).jacobian(0, 0);
  const double fx = factor * camera.pinhole.fx, fy = factor * camera.pinhole.fy;
  const std::string label = fmt::format(
      "label {:.2f} x {:.2f} degrees, of the focal lengths {:.6g} and "
      "{:.6g} on the axis; ",
      degrees(2 * std::atan(0.5 * camera.pinhole.width / fx)),
      degrees(2 * std::atan(0.5 * camera.pinhole.height / fy)), fx, fy);
  const auto seen = seen_fov(camera, region);
  if (!seen) return label + "the seen angles are unknown, as the image goes beyond what is proved";
  return label + fmt::format("seen {:.2f} horizontally, {:.2f} vertically, {:.2f} diagonally",
                             degrees(seen->horizontal_rad), degrees(seen->vertical_rad),
                             degrees(seen->diagonal_rad));
}

std::string region_text(const LensModel& lens, const RayRegion& region) {
  const std::string proved =
      fmt::format("proved up to {:.2f} degrees off the axis", degrees(region.max_angle_rad));
  if (region.box)
    return proved +
           fmt::format(", where rays meet the lens' plane between ({:.4f}, {:.4f}) and ({:.4f}, {:.4f})",
                       region.box->min().x(), region.box->min().y(), region.box->max().x(),
                       region.box->max().y());
  return proved + fmt::format("; the lens itself is one-to-one up to {:.2f}",
                              degrees(certify_region(lens).region.max_angle_rad));
}

}  // namespace

void print_line(const char* subject, const std::string& text) {
  fmt::print("  {:<16} {}\n", subject, text);
}

double percent(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

void print_camera(const ModelCamera& camera) {
  const Pinhole& pinhole = camera.pinhole;
  fmt::print("camera {}: {} x {}, fx {:.6g}, fy {:.6g}, cx {:.6g}, cy {:.6g}\n", camera.name, pinhole.width,
             pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
  print_line("lens", description(camera.lens));
}

std::string check_camera(const ModelCamera& camera) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens))
    return check_brown_conrady({camera.name, camera.pinhole, *lens});
  const ModelCertificate proof = certify_frame(camera);
  const ModelSurvey survey = survey_inversion(camera, proof.region);
  print_camera(camera);
  print_line("one-to-one", verdict(proof, survey));
  print_line("field of view", angles(camera, proof.region));
  print_line("region", region_text(camera.lens, proof.region));
  print_line("inversion", fmt::format("worst residual {:.1e} px on {} pixels", survey.worst_residual_px,
                                      survey.pixels - survey.outside));
  return proof.valid ? "" : proof.why;
}

}  // namespace cps
