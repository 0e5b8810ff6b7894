#include "dataset/labels/group_label.h"

#include <stdexcept>

#include "dataset/labels/label_check.h"
#include "distortion/certificate/certificate.h"
#include "distortion/crop/true_fov.h"
#include "numbers/angles.h"

namespace cps {
namespace {

/// What does not follow from the lens.
template <typename AnyLabel>
void set_origin(AnyLabel& label, const Plan& plan, const PlannedGroup& group) {
  label.vehicle_from_camera = vehicle_from_camera(plan.rig.cameras[group.camera]);
  label.part = group.part;
  label.seed = plan.recipe.seed;
}

}  // namespace

std::string generator_name() {
  return "cps " CPS_VERSION;
}

Label lens_label(const DrawnLens& lens, const LensBounds& bounds) {
  const Eigen::AlignedBox2d frame = frame_on_plane(lens.base);
  const Certificate certificate =
      certify(lens.distortion, frame,
              {.min_eigenvalue = bounds.min_eigenvalue, .max_eigenvalue = bounds.max_eigenvalue});
  if (!certificate.valid) throw std::runtime_error("lens is not certified: " + certificate.why);
  const auto angles = true_fov(lens.distortion, lens.crop.camera, frame);
  // The crop keeps the whole frame inside the lens' image of the master, where every ray has an angle.
  if (!angles) throw std::runtime_error("lens shows less than its crop: its true angles are not defined");
  Label label{.camera = lens.crop.camera,
              .distortion = lens.distortion,
              .fov_base_deg = degrees(hfov_rad(lens.base)),
              .fov_true_h_deg = degrees(angles->horizontal_rad),
              .fov_true_v_deg = degrees(angles->vertical_rad),
              .fov_true_d_deg = degrees(angles->diagonal_rad),
              .zoom = lens.crop.zoom,
              .certificate_min_eigenvalue = certificate.min_eigenvalue,
              .certificate_max_roundtrip_px = 0,
              .limits = lens.limits,
              .rig_camera = {},
              .generator = generator_name()};
  label.certificate_max_roundtrip_px = check_label(label).max_roundtrip_px;
  return label;
}

Label group_label(const Plan& plan, const PlannedGroup& group) try {
  Label label = lens_label(group.lens, plan.recipe.lens_options.bounds);
  label.rig_camera = plan.rig.cameras[group.camera].name;
  set_origin(label, plan, group);
  return label;
} catch (const std::runtime_error& error) {
  throw std::runtime_error(group.folder + ": " + error.what());
}

ModelLabel group_model_label(const Plan& plan, const PlannedGroup& group, bool is_masked) try {
  ModelCamera camera = group.model.value();
  camera.name = plan.rig.cameras[group.camera].name;
  ModelLabel label = is_masked ? masked_model_label(camera) : model_label(camera);
  set_origin(label, plan, group);
  return label;
} catch (const std::runtime_error& error) {
  throw std::runtime_error(group.folder + ": " + error.what());
}

}  // namespace cps
