#include "apps/render/lens.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "apps/options.h"
#include "apps/render/text_options.h"
#include "dataset/exchange/calibration_file.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/crop.h"
#include "distortion/label_algebra.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"

namespace po = boost::program_options;

namespace cps {
namespace {

bool is_coefficients(const std::string& text) {
  return text.size() > 2 && (text[0] == 'k' || text[0] == 'p') && text[2] == '=';
}

/// "k1=…,p2=…", in any order; missing coefficients are 0.
Distortion parse_coefficients(const std::string& text) {
  Distortion lens;
  const std::pair<const char*, double*> names[] = {
      {"k1=", &lens.k1}, {"k2=", &lens.k2}, {"k3=", &lens.k3}, {"p1=", &lens.p1}, {"p2=", &lens.p2}};
  for (const auto& part : flag_value<std::vector<std::string>>("lens", text)) {
    double* target = nullptr;
    for (const auto& [name, coefficient] : names)
      if (part.starts_with(name)) target = coefficient;
    if (!target)
      throw po::error("--lens " + text + ": '" + part + "' must be k1=, k2=, k3=, p1= or p2= and a number");
    *target = parse_numbers("lens", part.substr(3), 1, "coefficients like k1=-0.2,k2=0.05")[0];
  }
  return lens;
}

/// A master around the rectangle that the picture sees, with the picture's resolution where the lens does not
/// magnify.
Pinhole master_around(const FrameCertificate& proof, const Pinhole& picture) {
  const double focal = std::max(picture.fx, picture.fy);
  const Eigen::Vector2d first = focal * proof.rectangle.min(), last = focal * proof.rectangle.max();
  const Pinhole base{.width = static_cast<int>(std::ceil(last.x() - first.x())),
                     .height = static_cast<int>(std::ceil(last.y() - first.y())),
                     .fx = focal,
                     .fy = focal,
                     .cx = -first.x() - 0.5,
                     .cy = -first.y() - 0.5};
  constexpr double min_eigenvalue = 0.05;  // below, the pad would be larger than the picture
  return master_camera(base, WarpOptions{}, std::max(min_eigenvalue, proof.certificate.min_eigenvalue));
}

LensView cropped_view(const Distortion& lens, const Camera& ideal) {
  const Pinhole& base = ideal.pinhole;
  const Crop crop = border_free_crop(lens, base, {base.cx, base.cy});
  if (!crop.valid) throw std::runtime_error("--lens: " + crop.why);
  return {.seen = {.world_from_camera = ideal.world_from_camera, .pinhole = crop.camera, .lens = lens},
          .master = master_camera(base, WarpOptions{}, CertificateOptions{}.min_eigenvalue),
          .ideal_box = frame_on_plane(base)};
}

LensView calibrated_view(const RenderRequest& request, const Camera& ideal) {
  const std::filesystem::path file = *request.lens;
  CalibratedCamera calibrated = read_camera(file, request.lens_camera.value_or(""));
  if (request.hfov_deg) throw po::error("--hfov: leave it out; the --lens file defines the field of view");
  if (request.size) calibrated = resized(calibrated, ideal.pinhole.width, ideal.pinhole.height);
  const FrameCertificate proof = certify_frame(calibrated.distortion, calibrated.pinhole, one_to_one);
  if (!proof.valid()) throw std::runtime_error(file.string() + ": " + proof.why);
  return {.seen = {.world_from_camera = ideal.world_from_camera,
                   .pinhole = calibrated.pinhole,
                   .lens = calibrated.distortion},
          .master = master_around(proof, calibrated.pinhole),
          .ideal_box = proof.rectangle};
}

}  // namespace

LensView lens_view(const RenderRequest& request, const Camera& ideal) {
  if (!request.lens) return {.seen = ideal, .master = {}, .ideal_box = {}};
  if (is_coefficients(*request.lens)) return cropped_view(parse_coefficients(*request.lens), ideal);
  return calibrated_view(request, ideal);
}

OIIO::ImageBuf render_through(const RenderScene& scene, const LensView& view, const RenderRequest& request,
                              RenderSummary* summary, OIIO::ImageBuf* variance) {
  if (!view.seen.lens || request.lens_in_camera)
    return render(scene, view.seen, request.render, summary, variance);
  const Camera master{.world_from_camera = view.seen.world_from_camera, .pinhole = view.master};
  const OIIO::ImageBuf image = render(scene, master, request.render, summary);
  return warp(image, view.master, *view.seen.lens, view.seen.pinhole, {.box = view.ideal_box});
}

}  // namespace cps
