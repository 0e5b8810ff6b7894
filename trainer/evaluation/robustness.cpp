#include "trainer/evaluation/robustness.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

#include "trainer/evaluation/lens_errors.h"
#include "trainer/images/corruptions.h"
#include "trainer/images/network_image.h"

namespace cps {
namespace {

struct Corruption {
  const char* name;
  /// `unit_px`: length of a pixel of the network's image, in pixels of the given one.
  std::function<void(GrayImage&, double unit_px, Stream)> apply;
};

const std::vector<Corruption>& corruptions() {
  const auto soft = [](double sigma) {
    return [=](GrayImage& image, double unit_px, Stream) { blur(image, sigma * unit_px); };
  };
  const auto streak = [](double length) {
    return [=](GrayImage& image, double unit_px, Stream stream) {
      motion_blur(image, length * unit_px, random_uniform(stream, 0, 0, std::numbers::pi));
    };
  };
  const auto curve = [](double gamma) {
    return [=](GrayImage& image, double, Stream) { apply_gamma(image, gamma); };
  };
  const auto noise = [](double sigma) {
    return [=](GrayImage& image, double, Stream stream) { add_iso_noise(image, sigma, stream); };
  };
  static const std::vector<Corruption> table{
      {"as it is", [](GrayImage&, double, Stream) {}},
      {"Gaussian blur, 1 px", soft(1)},
      {"Gaussian blur, 2 px", soft(2)},
      {"motion blur, 5 px", streak(5)},
      {"motion blur, 9 px", streak(9)},
      {"gamma 0.5", curve(.5)},
      {"gamma 2", curve(2)},
      {"ISO noise, 10 of 255", noise(10)},
      {"ISO noise, 25 of 255", noise(25)},
  };
  return table;
}

/// The images of the set, corrupted, as the network takes them.
std::vector<NetworkImage> corrupted(const Corruption& corruption, const TrainOptions& options,
                                    const EvaluationSet& set,
                                    const std::function<GrayImage(std::size_t i)>& picture,
                                    std::uint64_t seed) {
  const Stream stream = make_stream(seed, corruption.name);
  std::vector<NetworkImage> images(set.images.size());
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    const Pinhole& camera = set.images[i].truth.pinhole;
    const ImageSize original{camera.width, camera.height},
        reduced = reduced_size(original, options.reduction);
    GrayImage image = picture(i);
    corruption.apply(image, static_cast<double>(image.size.width) / reduced.width, substream(stream, i));
    if (options.orientation.measured)
      images[i] = network_image_of_measured(image, original, options.reduction);
    else
      images[i].gray = std::move(image);
  });
  return images;
}

RobustnessRow measure(const Predictor& predictor, const EvaluationSet& set,
                      std::span<const NetworkImage> images, const std::string& name) {
  const ModelCard& card = predictor.card();
  const TrainOptions& options = card.options;
  std::vector<BatchImage> batch;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Pinhole& camera = set.images[i].truth.pinhole;
    batch.push_back(batch_image(images[i], {camera.width, camera.height}));
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
                                      const std::function<GrayImage(std::size_t i)>& picture,
                                      std::uint64_t seed) {
  std::vector<RobustnessRow> rows;
  for (const Corruption& corruption : corruptions())
    rows.push_back(measure(predictor, set,
                           corrupted(corruption, predictor.card().options, set, picture, seed),
                           corruption.name));
  return rows;
}

}  // namespace cps
