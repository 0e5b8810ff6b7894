#include "trainer/evaluation/robustness.h"

#include <algorithm>
#include <functional>
#include <numbers>

#include "trainer/evaluation/lens_errors.h"
#include "trainer/images/corruptions.h"

namespace cps {
namespace {

struct Corruption {
  const char* name;
  std::function<void(GrayImage&, Stream)> apply;
};

const std::vector<Corruption>& corruptions() {
  const auto streak = [](double length_px) {
    return [=](GrayImage& image, Stream stream) {
      motion_blur(image, length_px, random_uniform(stream, 0, 0, std::numbers::pi));
    };
  };
  static const std::vector<Corruption> table{
      {"as it is", [](GrayImage&, Stream) {}},
      {"Gaussian blur, 1 px", [](GrayImage& image, Stream) { blur(image, 1); }},
      {"Gaussian blur, 2 px", [](GrayImage& image, Stream) { blur(image, 2); }},
      {"motion blur, 5 px", streak(5)},
      {"motion blur, 9 px", streak(9)},
      {"gamma 0.5", [](GrayImage& image, Stream) { apply_gamma(image, .5); }},
      {"gamma 2", [](GrayImage& image, Stream) { apply_gamma(image, 2); }},
      {"ISO noise, 10 of 255", [](GrayImage& image, Stream stream) { add_iso_noise(image, 10, stream); }},
      {"ISO noise, 25 of 255", [](GrayImage& image, Stream stream) { add_iso_noise(image, 25, stream); }},
  };
  return table;
}

RobustnessRow measure(const Predictor& predictor, const EvaluationSet& set, std::span<const GrayImage> images,
                      const std::string& name) {
  const ModelCard& card = predictor.card();
  const TrainOptions& options = card.options;
  std::vector<BatchImage> batch;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Pinhole& camera = set.images[i].truth.pinhole;
    batch.push_back({{images[i].size, images[i].pixels.data()}, {camera.width, camera.height}});
  }
  const std::vector<Outputs> predicted = predictor(batch);
  RobustnessRow row{.name = name};
  std::vector<LensPrediction> predictions;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const CalibratedCamera& truth = set.images[i].truth;
    const Outputs a = standardise(predicted[i], card.targets),
                  b = standardise(to_outputs(truth, options.target_space), card.targets);
    for (int k = 0; k < output_count; ++k)
      if (std::ranges::find(options.outputs, output_names[k]) != options.outputs.end())
        row.loss +=
            (a[k] - b[k]) * (a[k] - b[k]) / static_cast<double>(options.outputs.size() * predicted.size());
    predictions.push_back({&truth, set.images[i].rays.get(),
                           convert(predicted[i], options.target_space, TargetSpace::raw, truth.pinhole.width,
                                   truth.pinhole.height)});
  }
  const LensErrors errors = measure_errors(predictions);
  row.hfov_mean_deg = errors.hfov_mean_deg;
  row.reprojection_mean_px = errors.reprojection_mean_px;
  return row;
}

}  // namespace

std::vector<RobustnessRow> robustness(const Predictor& predictor, const EvaluationSet& set,
                                      std::span<const GrayImage> images, std::uint64_t seed) {
  std::vector<RobustnessRow> rows;
  for (const Corruption& corruption : corruptions()) {
    std::vector<GrayImage> corrupted(images.begin(), images.end());
    const Stream stream = make_stream(seed, corruption.name);
    for (std::size_t i = 0; i < corrupted.size(); ++i) corruption.apply(corrupted[i], substream(stream, i));
    rows.push_back(measure(predictor, set, corrupted, corruption.name));
  }
  return rows;
}

}  // namespace cps
