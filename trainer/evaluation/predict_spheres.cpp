#include "trainer/evaluation/predict_spheres.h"

#include <fmt/format.h>

#include <stdexcept>

#include "dataset/exchange/camera_json.h"
#include "dataset/labels/label.h"
#include "dataset/labels/model_label.h"
#include "distortion/models/certificate/model_certificate.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "trainer/images/network_image.h"

namespace cps {
namespace {

/// The camera in calibration.json beside the image, if there is one.
std::optional<ModelCamera> camera_beside(const std::filesystem::path& image, const ImageSize& size) {
  const std::filesystem::path file = image.parent_path() / "calibration.json";
  if (!std::filesystem::exists(file)) return std::nullopt;
  const nlohmann::json json = read_json(file);
  ModelCamera camera;
  if (json.contains("params")) {
    camera = model_label_from_json(json, file.string()).camera;
  } else {
    const Label label = label_from_json(json, file.string());
    camera = {label.rig_camera, label.camera, label.distortion};
  }
  if (ImageSize{camera.pinhole.width, camera.pinhole.height} != size)
    throw std::runtime_error(
        fmt::format("{}: is {}x{}, not the size in its calibration.json: move one of them to another folder",
                    image.string(), size.width, size.height));
  return camera;
}

double xi_of(const ModelCamera& camera) {
  return std::get<UnifiedSpherical>(camera.lens).xi;
}

}  // namespace

std::vector<SpherePrediction> predict_spheres(const Predictor& predictor,
                                              std::span<const std::filesystem::path> files) {
  const TrainOptions& options = predictor.card().options;
  std::vector<SpherePrediction> predictions;
  std::vector<ImageSize> sizes;
  std::vector<NetworkImage> reduced;
  for (const std::filesystem::path& file : files) {
    const GrayImage gray = read_gray_image(file);
    sizes.push_back(gray.size);
    predictions.push_back({.file = file, .camera = {}, .truth = camera_beside(file, gray.size)});
    reduced.push_back(network_image(gray, options.reduction, options.orientation));
  }
  std::vector<BatchImage> batch;
  for (std::size_t i = 0; i < reduced.size(); ++i) batch.push_back(batch_image(reduced[i], sizes[i]));
  const std::vector<SphereTarget> predicted = predictor.spheres(batch);
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    SpherePrediction& p = predictions[i];
    p.camera = to_model_camera(predicted[i], sizes[i].width, sizes[i].height);
    p.camera.name = p.file.stem().string();
    p.seen_hfov_rad = seen_hfov_rad(predicted[i], sizes[i].width);
    p.is_one_to_one = certify_frame(p.camera).valid;
    if (!p.truth) continue;
    if (const auto truth = ray_truth(*p.truth)) p.errors = ray_errors(*truth, p.camera);
  }
  return predictions;
}

std::string report(std::span<const SpherePrediction> predictions) {
  std::string text;
  for (const SpherePrediction& p : predictions) {
    const Pinhole& pinhole = p.camera.pinhole;
    text += fmt::format(
        "{} ({}x{})\n  unified_spherical  focal {:.5g} px  xi {:.4g}  seen H-FOV {:.2f} deg  (paraxial focal "
        "{:.5g} px)\n",
        p.file.string(), pinhole.width, pinhole.height, pinhole.fx, xi_of(p.camera), degrees(p.seen_hfov_rad),
        pinhole.fx / (1 + xi_of(p.camera)));
    if (!p.is_one_to_one) text += "  the predicted lens does not show the whole frame\n";
    if (p.truth)
      text +=
          fmt::format("  true lens: {}, focal {:.5g} px\n", description(p.truth->lens), p.truth->pinhole.fx);
    if (p.errors.angles)
      text += fmt::format("  angle of rays {:.3g} deg, {:.3g} deg after the best turn\n",
                          p.errors.angles->mean_deg, p.errors.angles->turned_mean_deg);
    if (p.errors.reprojection_px)
      text += fmt::format("  reprojection error {:.2f} px\n", *p.errors.reprojection_px);
    if (p.errors.seen_hfov_deg)
      text += fmt::format("  error of the seen H-FOV {:.2f} deg\n", *p.errors.seen_hfov_deg);
  }
  return text;
}

nlohmann::ordered_json to_json(std::span<const SpherePrediction> predictions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SpherePrediction& p : predictions) {
    nlohmann::ordered_json entry{{"file", p.file.string()},
                                 {"prediction", model_camera_json(p.camera.pinhole, p.camera.lens)},
                                 {"seen_hfov_deg", degrees(p.seen_hfov_rad)},
                                 {"one_to_one", p.is_one_to_one}};
    if (p.truth) entry["truth"] = model_camera_json(p.truth->pinhole, p.truth->lens);
    if (p.errors.angles) {
      entry["angle_mean_deg"] = p.errors.angles->mean_deg;
      entry["turned_mean_deg"] = p.errors.angles->turned_mean_deg;
    }
    if (p.errors.reprojection_px) entry["reprojection_px"] = *p.errors.reprojection_px;
    if (p.errors.seen_hfov_deg) entry["seen_hfov_error_deg"] = *p.errors.seen_hfov_deg;
    list.push_back(entry);
  }
  return list;
}

}  // namespace cps
