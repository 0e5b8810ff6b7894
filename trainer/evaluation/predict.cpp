#include "trainer/evaluation/predict.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "dataset/labels/label.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/images/augmentation.h"

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

/// What was said of the mirrored image, of the image itself: see mirrored().
Outputs unmirrored(Outputs raw, int width) {
  raw[5] = -raw[5];
  raw[6] = 1 - 1.0 / width - raw[6];
  return raw;
}

/// Standard deviation of what is said of changed looks at one image.
Outputs spread_of(const Predictor& predictor, const BatchImage& image, const PredictOptions& how) {
  if (how.looks < 2) return {};
  const Augmentation changes{.probability = .5, .max_cutout = 0};
  std::vector<GrayImage> looks;
  std::vector<BatchImage> batch;
  for (int i = 0; i < how.looks; ++i)
    looks.push_back(augmented(image.gray, changes, substream(make_stream(how.seed, "looks"), i)));
  for (int i = 0; i < how.looks; ++i)
    batch.push_back({{looks[i].size, looks[i].pixels.data()}, image.original, i % 2 == 1});
  const std::vector<Outputs> said = predictor(batch);
  Outputs mean{}, spread{};
  std::vector<Outputs> raw;
  for (int i = 0; i < how.looks; ++i) {
    const Outputs one = convert(said[i], predictor.card().options.target_space, TargetSpace::raw,
                                image.original.width, image.original.height);
    raw.push_back(batch[i].mirror ? unmirrored(one, image.original.width) : one);
    for (int k = 0; k < output_count; ++k) mean[k] += raw.back()[k] / how.looks;
  }
  for (const Outputs& one : raw)
    for (int k = 0; k < output_count; ++k) spread[k] += (one[k] - mean[k]) * (one[k] - mean[k]);
  for (double& s : spread) s = std::sqrt(s / (how.looks - 1));
  return spread;
}

/// The numbers a person wants: H-FOV in degrees, the principal point in pixels.
struct Row {
  const char* name;
  const char* unit;
  double (*value)(const Calibration&);
  int output;
  double (*unit_of_spread)(const Calibration&);  ///< of one raw unit
};

double one(const Calibration&) {
  return 1;
}

constexpr Row rows[] = {
    {"H-FOV", "deg", [](const Calibration& c) { return degrees(hfov_rad(c.camera)); }, 0,
     [](const Calibration&) { return degrees(1); }},
    {"k1", "", [](const Calibration& c) { return c.distortion.k1; }, 1, one},
    {"k2", "", [](const Calibration& c) { return c.distortion.k2; }, 2, one},
    {"k3", "", [](const Calibration& c) { return c.distortion.k3; }, 3, one},
    {"p1", "", [](const Calibration& c) { return c.distortion.p1; }, 4, one},
    {"p2", "", [](const Calibration& c) { return c.distortion.p2; }, 5, one},
    {"cx", "px", [](const Calibration& c) { return c.camera.cx; }, 6,
     [](const Calibration& c) { return double(c.camera.width); }},
    {"cy", "px", [](const Calibration& c) { return c.camera.cy; }, 7,
     [](const Calibration& c) { return double(c.camera.height); }},
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
                                            std::span<const std::filesystem::path> files,
                                            const PredictOptions& how) {
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
    if (p.calibration) p.certified = pull_to_certified(*p.calibration);
    p.spread = spread_of(predictor, images[i], how);
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
    const bool has_spread = p.spread != Outputs{};
    std::snprintf(line, sizeof line, "  %-10s %12s %12s %12s\n", "", "predicted", has_spread ? "spread" : "",
                  p.truth ? "true" : "");
    text += line;
    for (const Row& row : rows) {
      std::snprintf(line, sizeof line, "  %-5s %-4s %12.5g", row.name, row.unit, row.value(*p.calibration));
      text += line;
      std::snprintf(line, sizeof line, " %12.3g", p.spread[row.output] * row.unit_of_spread(*p.calibration));
      text += has_spread ? std::string(line) : std::string(13, ' ');
      if (p.truth) std::snprintf(line, sizeof line, " %12.5g", row.value(*p.truth));
      text += p.truth ? std::string(line) + "\n" : "\n";
    }
    if (!p.is_one_to_one) text += "  the predicted lens folds inside the frame\n";
    if (p.certified->kept < 1) {
      std::snprintf(line, sizeof line,
                    "  no certified lens: files and pictures made of it have %.0f %% of its distortion\n",
                    100 * p.certified->kept);
      text += line;
    }
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
    if (p.certified)
      entry["certified"] = {{"calibration", to_json(p.certified->calibration)}, {"kept", p.certified->kept}};
    if (p.spread != Outputs{}) {
      nlohmann::ordered_json spread;
      for (int i = 0; i < output_count; ++i) spread[output_names[i]] = p.spread[i];
      spread["fov"] = degrees(p.spread[0]);
      spread["cx"] = p.spread[6] * p.size.width;
      spread["cy"] = p.spread[7] * p.size.height;
      entry["spread"] = spread;
    }
    if (p.truth) entry["truth"] = to_json(*p.truth);
    if (p.reprojection_px) entry["reprojection_px"] = *p.reprojection_px;
    list.push_back(entry);
  }
  return list;
}

}  // namespace cps
