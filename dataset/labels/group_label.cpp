#include "dataset/labels/group_label.h"

#include <stdexcept>

#include "dataset/labels/label_check.h"
#include "distortion/certificate/certificate.h"
#include "distortion/crop/true_fov.h"
#include "numbers/angles.h"

namespace cps {

std::string generator_name() {
  return "cps " CPS_VERSION;
}

Label group_label(const Plan& plan, const PlannedGroup& group) {
  const RigCamera& camera = plan.rig.cameras[group.camera];
  const Eigen::AlignedBox2d frame = frame_on_plane(group.lens.base);
  const LensBounds& bounds = plan.recipe.lens_options.bounds;
  const Certificate certificate =
      certify(group.lens.distortion, frame,
              {.min_eigenvalue = bounds.min_eigenvalue, .max_eigenvalue = bounds.max_eigenvalue});
  if (!certificate.valid)
    throw std::runtime_error(group.folder + ": lens is not certified: " + certificate.why);
  // Never empty: the crop keeps the whole frame inside the lens' image of the master.
  const TrueFov true_angles = *true_fov(group.lens.distortion, group.lens.crop.camera, frame);
  Label label{.camera = group.lens.crop.camera,
              .distortion = group.lens.distortion,
              .fov_base_deg = degrees(hfov_rad(group.lens.base)),
              .fov_true_h_deg = degrees(true_angles.horizontal_rad),
              .fov_true_v_deg = degrees(true_angles.vertical_rad),
              .fov_true_d_deg = degrees(true_angles.diagonal_rad),
              .zoom = group.lens.crop.zoom,
              .certificate_min_eigenvalue = certificate.min_eigenvalue,
              .certificate_max_roundtrip_px = 0,
              .limits = group.lens.limits,
              .rig_camera = camera.name,
              .vehicle_from_camera = vehicle_from_camera(camera),
              .part = group.part,
              .seed = plan.recipe.seed,
              .generator = generator_name()};
  label.certificate_max_roundtrip_px = check_label(label).worst_roundtrip_px;
  return label;
}

}  // namespace cps
