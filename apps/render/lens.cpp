#include "apps/render/lens.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/crop.h"
#include "distortion/models/warp/seen_hfov.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"

namespace po = boost::program_options;

namespace cps {
namespace {

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
          .ideal_box = frame_on_plane(base),
          .shown_hfov_deg = degrees(hfov_rad(crop.camera))};
}

/// The calibration's camera, in the size that is asked for.
ModelCamera calibrated_camera(const RenderRequest& request, const Camera& ideal) {
  if (request.hfov_deg) throw po::error("--hfov: leave it out; the --lens file defines the field of view");
  const ModelCamera camera{
      .name = {}, .pinhole = *request.lens_choice->calibrated, .lens = request.lens_choice->lens};
  return request.size ? resized(camera, ideal.pinhole.width, ideal.pinhole.height) : camera;
}

LensView calibrated_view(const RenderRequest& request, const Camera& ideal) {
  const ModelCamera camera = calibrated_camera(request, ideal);
  const auto& lens = std::get<Distortion>(camera.lens);
  const FrameCertificate proof = certify_frame(lens, camera.pinhole, one_to_one);
  if (!proof.valid()) throw std::runtime_error(*request.lens + ": " + proof.why);
  return {.seen = {.world_from_camera = ideal.world_from_camera, .pinhole = camera.pinhole, .lens = lens},
          .master = master_around(proof, camera.pinhole),
          .ideal_box = proof.rectangle,
          .shown_hfov_deg = degrees(hfov_rad(camera.pinhole))};
}

/// The camera whose parameters --lens gives: it shows --hfov, else the ideal camera's angle.
ModelCamera parameter_camera(const RenderRequest& request, const Camera& ideal) {
  const double wanted_rad = request.hfov_deg ? radians(*request.hfov_deg) : hfov_rad(ideal.pinhole);
  const std::optional<ModelCamera> camera =
      camera_from_seen_hfov(request.lens_choice->lens, ideal.pinhole.width, ideal.pinhole.height, wanted_rad);
  if (!camera)
    throw std::runtime_error(
        fmt::format("--lens {}: is not one-to-one over an H-FOV of {:.4g} degrees: choose a smaller --hfov",
                    *request.lens, degrees(wanted_rad)));
  return *camera;
}

/// A view through a lens of another family than Brown–Conrady.
LensView model_view(const RenderRequest& request, const Camera& ideal) {
  const ModelCamera camera =
      request.lens_choice->calibrated ? calibrated_camera(request, ideal) : parameter_camera(request, ideal);
  const ModelCertificate proof = certify_frame(camera, one_to_one);
  if (!proof.valid && std::holds_alternative<RationalLens>(camera.lens))
    throw std::runtime_error(*request.lens + ": " + proof.why);
  if (!proof.valid) fmt::print(stderr, "{}: {}; the part beyond is left black\n", *request.lens, proof.why);
  const std::optional<double> shown_rad = seen_hfov_rad(camera, proof.region);
  LensView view{
      .seen = {.world_from_camera = ideal.world_from_camera, .pinhole = camera.pinhole, .lens = camera.lens},
      .master = {},
      .ideal_box = {},
      .shown_hfov_deg = {}};
  if (shown_rad) view.shown_hfov_deg = degrees(*shown_rad);
  return view;
}

}  // namespace

LensView lens_view(const RenderRequest& request, const Camera& ideal) {
  if (!request.lens) return {.seen = ideal, .master = {}, .ideal_box = {}, .shown_hfov_deg = {}};
  const LensChoice& named = *request.lens_choice;
  if (!named.is_brown_conrady()) return model_view(request, ideal);
  return named.calibrated ? calibrated_view(request, ideal)
                          : cropped_view(std::get<Distortion>(named.lens), ideal);
}

OIIO::ImageBuf render_through(const RenderScene& scene, const LensView& view, const RenderRequest& request,
                              RenderSummary* summary, OIIO::ImageBuf* variance) {
  if (!view.seen.lens || request.lens_in_camera)
    return render(scene, view.seen, request.render, summary, variance);
  const Camera master{.world_from_camera = view.seen.world_from_camera, .pinhole = view.master};
  const OIIO::ImageBuf image = render(scene, master, request.render, summary);
  return warp(image, view.master, std::get<Distortion>(*view.seen.lens), view.seen.pinhole,
              {.box = view.ideal_box});
}

}  // namespace cps
