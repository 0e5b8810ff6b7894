#include "trainer/predict.h"

#include <cstdio>
#include <stdexcept>

#include "dataset/files.h"
#include "dataset/label.h"
#include "trainer/reprojection.h"

namespace cps {
namespace {

std::optional<Calibration> truth_beside(const std::filesystem::path& image, const ImageSize& size) {
  const std::filesystem::path file = image.parent_path() / "calibration.json";
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Label label = label_from_json(read_json(file), file.string());
  if (ImageSize{label.camera.width, label.camera.height} != size)
    throw std::runtime_error(image.string() + ": is " + std::to_string(size.width) + "x" +
                             std::to_string(size.height) +
                             ", not the size in its calibration.json: move one of them away");
  return Calibration{label.camera, label.distortion};
}

/// The numbers a person wants: H-FOV in degrees, the principal point in pixels.
struct Row {
  const char* name;
  const char* unit;
  double (*value)(const Calibration&);
};

constexpr Row rows[] = {
    {"H-FOV", "deg", [](const Calibration& c) { return degrees(hfov_rad(c.camera)); }},
    {"k1", "", [](const Calibration& c) { return c.distortion.k1; }},
    {"k2", "", [](const Calibration& c) { return c.distortion.k2; }},
    {"k3", "", [](const Calibration& c) { return c.distortion.k3; }},
    {"p1", "", [](const Calibration& c) { return c.distortion.p1; }},
    {"p2", "", [](const Calibration& c) { return c.distortion.p2; }},
    {"cx", "px", [](const Calibration& c) { return c.camera.cx; }},
    {"cy", "px", [](const Calibration& c) { return c.camera.cy; }},
};

nlohmann::ordered_json to_json(const Calibration& c) {
  return {{"fov", degrees(hfov_rad(c.camera))},
          {"k1", c.distortion.k1},
          {"k2", c.distortion.k2},
          {"k3", c.distortion.k3},
          {"p1", c.distortion.p1},
          {"p2", c.distortion.p2},
          {"cx", c.camera.cx},
          {"cy", c.camera.cy}};
}

}  // namespace

std::vector<ImagePrediction> predict_images(const Predictor& predictor,
                                            std::span<const std::filesystem::path> files) {
  const TrainOptions& options = predictor.card().options;
  std::vector<ImagePrediction> predictions;
  std::vector<GrayImage> reduced;
  for (const std::filesystem::path& file : files) {
    const GrayImage gray = read_gray_image(file);
    predictions.push_back({.file = file, .size = gray.size});
    predictions.back().truth = truth_beside(file, gray.size);
    reduced.push_back(area_average(gray, reduced_size(gray.size, options.reduction)));
  }
  std::vector<BatchImage> images;
  for (std::size_t i = 0; i < reduced.size(); ++i)
    images.push_back({{reduced[i].size, reduced[i].pixels.data()}, predictions[i].size});
  const std::vector<Outputs> said = predictor(images);

  for (std::size_t i = 0; i < said.size(); ++i) {
    ImagePrediction& p = predictions[i];
    p.raw = convert(said[i], options.target_space, TargetSpace::raw, p.size.width, p.size.height);
    p.calibration = to_calibration(p.raw, TargetSpace::raw, p.size.width, p.size.height);
    p.is_one_to_one = p.calibration && is_one_to_one(*p.calibration);
    if (!p.truth || !p.calibration) continue;
    if (const auto rays = ray_grid(*p.truth))
      p.reprojection_px = reprojection_error_px(*rays, *p.calibration);
  }
  return predictions;
}

std::string report(std::span<const ImagePrediction> predictions) {
  std::string text;
  char line[160];
  for (const ImagePrediction& p : predictions) {
    text +=
        p.file.string() + " (" + std::to_string(p.size.width) + "x" + std::to_string(p.size.height) + ")\n";
    if (!p.calibration) {
      std::snprintf(line, sizeof line, "  no camera: the network says an H-FOV of %.1f deg\n",
                    degrees(p.raw[0]));
      text += line;
      continue;
    }
    std::snprintf(line, sizeof line, "  %-10s %12s %12s\n", "", "predicted", p.truth ? "true" : "");
    text += line;
    for (const Row& row : rows) {
      std::snprintf(line, sizeof line, "  %-5s %-4s %12.5g", row.name, row.unit, row.value(*p.calibration));
      text += line;
      if (p.truth) std::snprintf(line, sizeof line, " %12.5g", row.value(*p.truth));
      text += p.truth ? std::string(line) + "\n" : "\n";
    }
    if (!p.is_one_to_one) text += "  the predicted lens folds inside the frame\n";
    if (p.reprojection_px) {
      std::snprintf(line, sizeof line, "  reprojection error %.2f px\n", *p.reprojection_px);
      text += line;
    }
  }
  return text;
}

nlohmann::ordered_json to_json(std::span<const ImagePrediction> predictions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ImagePrediction& p : predictions) {
    nlohmann::ordered_json entry{
        {"file", p.file.string()}, {"width", p.size.width}, {"height", p.size.height}};
    entry["prediction"] = p.calibration ? to_json(*p.calibration) : nlohmann::ordered_json(nullptr);
    entry["one_to_one"] = p.is_one_to_one;
    if (p.truth) entry["truth"] = to_json(*p.truth);
    if (p.reprojection_px) entry["reprojection_px"] = *p.reprojection_px;
    list.push_back(entry);
  }
  return list;
}

}  // namespace cps
