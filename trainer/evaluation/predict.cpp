#include "trainer/evaluation/predict.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <utility>

#include "distortion/label_algebra.h"
#include "numbers/angles.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/evaluation/camera_numbers.h"
#include "trainer/evaluation/truth_beside.h"
#include "trainer/images/augmentation.h"
#include "trainer/images/network_image.h"
#include "trainer/images/orientation/measure.h"

namespace cps {
namespace {

/// The outputs for an image, from those for its mirror image.
Outputs unmirrored(Outputs raw, const ImageSize& size) {
  CalibratedCamera camera{"", pinhole_from_hfov(size.width, size.height, 1), {.p2 = raw[5]}};
  camera.pinhole.cx = raw[6] * size.width;
  camera = mirrored_left_right(camera);
  raw[5] = camera.distortion.p2;
  raw[6] = camera.pinhole.cx / size.width;
  return raw;
}

/// Variants of an image: of the reduced one, or, for a network that takes orientation, of the picture that it
/// is measured in.
std::vector<NetworkImage> variants_of(const std::filesystem::path& file, const NetworkImage& image,
                                      const ImageSize& original, const TrainOptions& options,
                                      const PredictOptions& how) {
  const Augmentation changes{.probability = .5, .max_cutout = 0};
  const bool with_orientation = options.orientation.measured;
  const GrayImage picture = with_orientation ? measured_picture(read_gray_image(file), image.gray.size,
                                                                options.orientation.max_width)
                                             : image.gray;
  std::vector<NetworkImage> variants(how.variants);
  tbb::parallel_for(0, how.variants, [&](int i) {
    GrayImage changed = augmented({picture.size, picture.pixels.data()}, changes,
                                  substream(make_stream(how.seed, "looks"), i));
    if (with_orientation)
      variants[i] = network_image_of_measured(changed, original, options.reduction);
    else
      variants[i].gray = std::move(changed);
  });
  return variants;
}

/// Standard deviation of the predictions for variants of one image of size `original`.
Outputs spread_of(const Predictor& predictor, const std::vector<NetworkImage>& variants,
                  const ImageSize& original) {
  const int count = static_cast<int>(variants.size());
  std::vector<BatchImage> batch;
  for (int i = 0; i < count; ++i) batch.push_back(batch_image(variants[i], original, i % 2 == 1));
  const std::vector<Outputs> predicted = predictor(batch);
  Outputs mean{}, spread{};
  std::vector<Outputs> raw;
  for (int i = 0; i < count; ++i) {
    const Outputs one = convert(predicted[i], predictor.card().options.target_space, TargetSpace::raw,
                                original.width, original.height);
    raw.push_back(batch[i].mirror ? unmirrored(one, original) : one);
    for (int k = 0; k < output_count; ++k) mean[k] += raw.back()[k] / count;
  }
  for (const Outputs& one : raw)
    for (int k = 0; k < output_count; ++k) spread[k] += (one[k] - mean[k]) * (one[k] - mean[k]);
  for (double& s : spread) s = std::sqrt(s / (count - 1));
  return spread;
}

}  // namespace

std::vector<ImagePrediction> predict_images(const Predictor& predictor,
                                            std::span<const std::filesystem::path> files,
                                            const PredictOptions& how) {
  const TrainOptions& options = predictor.card().options;
  std::vector<ImagePrediction> predictions;
  std::vector<NetworkImage> reduced;
  for (const std::filesystem::path& file : files) {
    const GrayImage gray = read_gray_image(file);
    predictions.push_back({.file = file, .size = gray.size});
    predictions.back().truth = truth_beside(file, gray.size);
    reduced.push_back(network_image(gray, options.reduction, options.orientation));
  }
  std::vector<BatchImage> images;
  for (std::size_t i = 0; i < reduced.size(); ++i)
    images.push_back(batch_image(reduced[i], predictions[i].size));
  const auto raw = [&](const auto& said, const ImageSize& size) {
    return convert(said, options.target_space, TargetSpace::raw, size.width, size.height);
  };
  if (is_fit(options.head)) {
    const std::vector<LensPosterior> posteriors = predictor.posteriors(images);
    for (std::size_t i = 0; i < images.size(); ++i) {
      const LensPosterior posterior = raw(posteriors[i], predictions[i].size);
      predictions[i].raw = posterior.mean;
      predictions[i].deviation = posterior.deviation();
    }
  } else {
    const std::vector<Outputs> predicted = predictor(images);
    for (std::size_t i = 0; i < images.size(); ++i)
      predictions[i].raw = raw(predicted[i], predictions[i].size);
  }

  for (std::size_t i = 0; i < predictions.size(); ++i) {
    ImagePrediction& p = predictions[i];
    p.camera = to_camera(p.raw, TargetSpace::raw, p.size.width, p.size.height);
    if (p.camera) p.camera->name = p.file.stem().string();
    p.is_one_to_one = p.camera && is_one_to_one(*p.camera);
    if (p.camera) p.certified = pull_to_certified(*p.camera);
    if (how.variants >= 2)
      p.spread = spread_of(predictor, variants_of(p.file, reduced[i], p.size, options, how), p.size);
    if (!p.truth || !p.camera) continue;
    if (const auto rays = ray_grid(*p.truth)) p.reprojection_px = reprojection_error_px(*rays, *p.camera);
  }
  return predictions;
}

std::string report(std::span<const ImagePrediction> predictions) {
  std::string text;
  for (const ImagePrediction& p : predictions) {
    text += fmt::format("{} ({}x{})\n", p.file.string(), p.size.width, p.size.height);
    if (!p.camera) {
      text += fmt::format("  no camera: the predicted H-FOV is {:.1f} deg\n", degrees(p.raw[0]));
      continue;
    }
    const bool has_spread = p.spread != Outputs{};
    text += fmt::format("  {:<10} {:>12}{} {:>12} {:>12}\n", "", "predicted",
                        p.deviation ? fmt::format(" {:>12}", "deviation") : "", has_spread ? "spread" : "",
                        p.truth ? "true" : "");
    for (int i = 0; i < output_count; ++i) {
      const CameraNumber& number = camera_numbers()[i];
      text += fmt::format("  {:<5} {:<4} {:12.5g}", number.name, number.unit, number.value(*p.camera));
      if (p.deviation) text += fmt::format(" {:12.3g}", (*p.deviation)[i] * number.unit_of_raw(*p.camera));
      text += has_spread ? fmt::format(" {:12.3g}", p.spread[i] * number.unit_of_raw(*p.camera))
                         : std::string(13, ' ');
      if (p.truth) text += fmt::format(" {:12.5g}", number.value(*p.truth));
      text += "\n";
    }
    if (!p.is_one_to_one) text += "  the predicted lens folds inside the frame\n";
    if (p.certified->kept < 1)
      text += fmt::format(
          "  not a certified lens: calibrations and undistorted pictures have {:.0f} % of its distortion\n",
          100 * p.certified->kept);
    if (p.reprojection_px) text += fmt::format("  reprojection error {:.2f} px\n", *p.reprojection_px);
  }
  return text;
}

nlohmann::ordered_json to_json(std::span<const ImagePrediction> predictions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ImagePrediction& p : predictions) {
    nlohmann::ordered_json entry{
        {"file", p.file.string()}, {"width", p.size.width}, {"height", p.size.height}};
    entry["prediction"] = p.camera ? numbers_json(*p.camera) : nlohmann::ordered_json(nullptr);
    entry["one_to_one"] = p.is_one_to_one;
    if (p.certified)
      entry["certified"] = {{"calibration", numbers_json(p.certified->camera)}, {"kept", p.certified->kept}};
    if (p.deviation) entry["deviation"] = numbers_json(*p.deviation, p.size);
    if (p.spread != Outputs{}) entry["spread"] = numbers_json(p.spread, p.size);
    if (p.truth) entry["truth"] = numbers_json(*p.truth);
    if (p.reprojection_px) entry["reprojection_px"] = *p.reprojection_px;
    list.push_back(entry);
  }
  return list;
}

}  // namespace cps
