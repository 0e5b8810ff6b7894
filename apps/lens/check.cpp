#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "apps/lens/verbs.h"
#include "apps/options.h"
#include "dataset/exchange/calibration_file.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/radial_limit.h"
#include "distortion/crop/fields_of_view.h"
#include "distortion/inverse/inversion_survey.h"
#include "numbers/angles.h"

namespace po = boost::program_options;

namespace cps {
namespace {

void print_line(const char* subject, const std::string& text) {
  fmt::print("  {:<16} {}\n", subject, text);
}

double percent(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

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

/// Prints the report on one camera. Returns why its lens is refused; empty if it is one-to-one.
std::string check_camera(const CalibratedCamera& calibrated) {
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

}  // namespace

const Manual lens_check_manual{
    .name = "cps lens check",
    .summary = "prove that a calibration is one-to-one",
    .synopsis = {"CALIBRATION [--camera NAME]"},
    .description = R"(
Proves that the lens of a calibration maps its whole frame one-to-one, or says
where it does not. Prints the true angles of view, how exactly the lens is
inverted, and where common iterative inverses fail on it.

Reads cps' calibration.json, OpenCV's YAML and XML, COLMAP's cameras.txt, ROS'
camera_info, KITTI's calib_cam_to_cam.txt, Kalibr's camchain, nerfstudio's
transforms.json and others.
)",
    .exit_status = {{"0", "every lens is one-to-one"},
                    {"1", "failed, or a lens is not one-to-one; stderr says why"},
                    {"2", "wrong usage"}},
    .examples = {{"cps lens check calib_cam_to_cam.txt --camera 00", "checks the first of KITTI's cameras"}},
    .see_also = {"cps lens"},
};

int cps_lens_check(const Arguments& arguments) {
  std::string file, camera, size;
  po::options_description options("Options");
  options.add_options()("file", po::value(&file)->value_name("FILE")->required(),
                        "the calibration; its name alone will do, without --file")(
      "camera", po::value(&camera)->value_name("NAME"),
      "name of the camera to check [all cameras of the file]")(
      "size", po::value(&size)->value_name("WxH"),
      "WIDTHxHEIGHT of the pictures, for files that do not say it");
  po::positional_options_description positional;
  positional.add("file", 1);
  po::variables_map values;
  if (!parse_options(arguments, lens_check_manual, options, positional, values)) return 0;
  po::notify(values);
  const ImageSize pictures = size.empty() ? ImageSize{0, 0} : flag_value<ImageSize>("size", size);
  const CalibrationFile read = camera.empty() ? read_calibration_file(file, pictures)
                                              : CalibrationFile{{read_camera(file, camera, pictures)}, {}};
  bool all_valid = read.unread.empty();
  for (const UnreadCamera& unread : read.unread) std::cerr << "cps: " << unread.fault << "\n";
  for (const CalibratedCamera& calibrated : read.cameras) {
    const std::string why = check_camera(calibrated);
    std::fflush(stdout);
    if (why.empty()) continue;
    std::cerr << "cps: " << file << ": camera " << calibrated.name << ": " << why << "\n";
    all_valid = false;
  }
  return all_valid ? 0 : 1;
}

}  // namespace cps
