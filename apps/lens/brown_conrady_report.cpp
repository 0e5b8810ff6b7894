#include <fmt/format.h>

#include <cmath>

#include "apps/lens/report.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/radial_limit.h"
#include "distortion/crop/fields_of_view.h"
#include "distortion/inverse/inversion_survey.h"
#include "numbers/angles.h"

namespace cps {
namespace {

std::string verdict(const FrameCertificate& proof, const InversionSurvey& survey) {
  if (proof.valid())
    return fmt::format("yes, proved: local scale {:.4f} to {:.4f} wherever the image looks",
                       proof.certificate.min_eigenvalue, proof.certificate.max_eigenvalue);
  return fmt::format("no: proved for {} of {} pixels ({:.3f} %) only", survey.pixels - survey.outside,
                     survey.pixels, percent(survey.pixels - survey.outside, survey.pixels));
}

std::string angles(const FieldsOfView& fov) {
  const std::string label = fmt::format("label {:.2f} x {:.2f} degrees; ", degrees(fov.label_horizontal_rad),
                                        degrees(fov.label_vertical_rad));
  if (!fov.seen) return label + "the seen angles are unknown, as the image goes beyond what is proved";
  return label + fmt::format("seen {:.2f} horizontally, {:.2f} vertically, {:.2f} diagonally",
                             degrees(fov.seen->horizontal_rad), degrees(fov.seen->vertical_rad),
                             degrees(fov.seen->diagonal_rad));
}

std::string radial_limit_text(const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const double limit = radial_limit(lens);
  if (!std::isfinite(limit)) return "none: the radial part grows for ever";
  const double corner = rectangle.min().cwiseAbs().cwiseMax(rectangle.max().cwiseAbs()).norm();
  return fmt::format("radius {:.4f}, {:.2f} degrees off the axis; the proof covers radius {:.4f}", limit,
                     degrees(std::atan(limit)), corner);
}

std::string errors_text(const InverterErrors& errors, std::int64_t pixels) {
  if (errors.wrong_pixels == 0) return "none";
  return fmt::format("{:.3g} %, the first at ({:.0f}, {:.0f}), {:.0f} px off the principal point; worst {}",
                     percent(errors.wrong_pixels, pixels), errors.first_wrong_px.x(),
                     errors.first_wrong_px.y(), errors.first_wrong_radius_px,
                     errors.worst_px < 1e6 ? fmt::format("{:.3g} px", errors.worst_px) : "beyond all bounds");
}

}  // namespace

std::string check_brown_conrady(const CalibratedCamera& calibrated) {
  const auto& [name, camera, lens] = calibrated;
  const FrameCertificate proof = certify_frame(lens, camera, one_to_one);
  const InversionSurvey survey = survey_inversion(calibrated, proof.rectangle);
  const std::int64_t inside = survey.pixels - survey.outside;

  fmt::print("camera {}: {} x {}, fx {:.6g}, fy {:.6g}, cx {:.6g}, cy {:.6g}\n", name, camera.width,
             camera.height, camera.fx, camera.fy, camera.cx, camera.cy);
  print_line("lens", fmt::format("k1 {:.6g}, k2 {:.6g}, k3 {:.6g}, p1 {:.6g}, p2 {:.6g}", lens.k1, lens.k2,
                                 lens.k3, lens.p1, lens.p2));
  print_line("one-to-one", verdict(proof, survey));
  print_line("field of view", angles(fields_of_view(calibrated, proof.rectangle)));
  print_line("radial limit", radial_limit_text(lens, proof.rectangle));
  print_line("largest t", fmt::format("{:.4g}: that many times this lens is still one-to-one there",
                                      proof.certificate.largest_scale));
  print_line("inversion",
             fmt::format("worst residual {:.1e} px on {} pixels", survey.worst_residual_px, inside));
  print_line("other inverters", fmt::format("pixels off by more than {} px", InversionSurvey::tolerance_px));
  for (const InverterErrors& other : survey.others)
    print_line("", fmt::format("{:<24} {}", other.name, errors_text(other, inside)));
  return proof.valid() ? "" : proof.why;
}

}  // namespace cps
