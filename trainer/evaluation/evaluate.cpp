#include "trainer/evaluation/evaluate.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "numbers/angles.h"
#include "trainer/evaluation/bootstrap.h"
#include "trainer/evaluation/predicted_cameras.h"
#include "trainer/evaluation/read_pictures.h"
#include "trainer/images/network_image.h"
#include "trainer/images/orientation/measure.h"

namespace cps {
namespace {

/// The set's images as the network takes them. Unreadable images are removed from the set with a line in
/// `skipped`, or are an error.
std::vector<NetworkImage> read_images(EvaluationSet& set, const TrainOptions& options, bool skip_bad,
                                      std::vector<std::string>& skipped) {
  std::vector<SizedPicture> pictures;
  for (const EvaluationImage& image : set.images)
    pictures.push_back({image.file, {image.truth.pinhole.width, image.truth.pinhole.height}});
  ReadPictures read = read_pictures(pictures, options, skip_bad);
  skipped = std::move(read.skipped);
  EvaluationSet kept{.name = set.name, .images = {}};
  for (int i : read.kept) kept.images.push_back(set.images[i]);
  set = std::move(kept);
  return std::move(read.images);
}

Outputs centred_without_distortion(double fov, const Pinhole& camera) {
  return to_outputs({"", pinhole_from_hfov(camera.width, camera.height, fov), {}}, TargetSpace::raw);
}

std::vector<EvaluatedImage> judge(const Predictor& predictor, const EvaluationSet& set,
                                  const std::vector<NetworkImage>& images) {
  const ModelCard& card = predictor.card();
  const TargetSpace space = card.options.target_space;
  std::vector<BatchImage> batch;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Pinhole& camera = set.images[i].truth.pinhole;
    batch.push_back(batch_image(images[i], {camera.width, camera.height}));
  }
  const std::vector<Outputs> predicted = predictor(batch);
  std::vector<EvaluatedImage> judged(set.images.size());
  tbb::parallel_for(std::size_t{0}, judged.size(), [&](std::size_t i) {
    const EvaluationImage& image = set.images[i];
    const Pinhole& camera = image.truth.pinhole;
    const auto raw = [&](const Outputs& outputs) {
      return convert(outputs, space, TargetSpace::raw, camera.width, camera.height);
    };
    const auto errors = [&](const Outputs& outputs) {
      return image_errors({&image.truth, image.rays.get(), outputs});
    };
    judged[i] = {image, raw(predicted[i]), errors(raw(predicted[i])), errors(raw(card.targets.mean)),
                 errors(centred_without_distortion(card.targets.mean[0], camera))};
  });
  return judged;
}

/// Over the chosen images; repeated ones count repeatedly.
LensErrors summary_of(const std::vector<EvaluatedImage>& images, std::span<const int> chosen,
                      ImageErrors EvaluatedImage::*of) {
  std::vector<ImageErrors> errors;
  std::vector<double> fov;
  for (int i : chosen) {
    errors.push_back(images[i].*of);
    fov.push_back(hfov_rad(images[i].image.truth.pinhole));
  }
  return summarise(errors, fov);
}

Headline headline(const std::vector<EvaluatedImage>& images, std::span<const int> all,
                  const EvaluationOptions& options) {
  std::vector<int> clusters;
  for (const EvaluatedImage& image : images) clusters.push_back(image.image.cluster);
  const auto numbers = [&](std::span<const int> chosen) {
    const LensErrors network = summary_of(images, chosen, &EvaluatedImage::network),
                     mean = summary_of(images, chosen, &EvaluatedImage::training_mean);
    return std::vector{network.hfov_mean_deg,
                       network.hfov_median_deg,
                       network.hfov_correlation,
                       network.reprojection_mean_px,
                       network.reprojection_median_px,
                       network.hfov_mean_deg / mean.hfov_mean_deg,
                       network.reprojection_mean_px / mean.reprojection_mean_px};
  };
  const std::vector<double> value = numbers(all);
  const std::vector<Interval> interval =
      bootstrap_intervals(clusters, numbers, options.resamples, make_stream(options.seed, "bootstrap"));
  const auto estimate = [&](int i) { return Estimate{value[i], interval[i]}; };
  return {estimate(0), estimate(1), estimate(2), estimate(3), estimate(4), estimate(5), estimate(6)};
}

RayComparison ray_comparison(const Predictor& predictor, const std::vector<EvaluatedImage>& images,
                             const EvaluationOptions& options) {
  std::vector<RayErrors> network(images.size()), mean(images.size());
  std::vector<int> clusters;
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    const EvaluationImage& image = images[i].image;
    const ImageSize size{image.truth.pinhole.width, image.truth.pinhole.height};
    network[i] = ray_errors(*image.ray_truth, predicted_camera(images[i].predicted, TargetSpace::raw, size));
    mean[i] = ray_errors(*image.ray_truth, training_mean_camera(predictor.card(), size));
  });
  for (const EvaluatedImage& image : images) clusters.push_back(image.image.cluster);
  return compare_rays(network, mean, clusters, options.resamples, options.seed);
}

std::vector<EvaluationBin> bins_of(const std::vector<EvaluatedImage>& images) {
  std::map<std::pair<int, std::string>, std::vector<int>> members;  // kind, name
  for (int i = 0; i < static_cast<int>(images.size()); ++i) {
    const EvaluationImage& image = images[i].image;
    const int tens = static_cast<int>(std::floor(degrees(hfov_rad(image.truth.pinhole)) / 10)) * 10;
    members[{0, fmt::format("{:3} to {:3} deg", tens, tens + 10)}].push_back(i);
    members[{1, fmt::format("{}x{}", image.truth.pinhole.width, image.truth.pinhole.height)}].push_back(i);
    members[{2, image.camera}].push_back(i);
  }
  static constexpr std::array kinds{"H-FOV", "size", "camera"};
  std::vector<EvaluationBin> bins;
  for (const auto& [key, chosen] : members)
    bins.push_back({kinds[key.first], key.second, static_cast<int>(chosen.size()),
                    summary_of(images, chosen, &EvaluatedImage::network),
                    summary_of(images, chosen, &EvaluatedImage::training_mean)});
  return bins;
}

}  // namespace

std::string EvaluationOptions::fault() const {
  return resamples >= 0 && resamples <= 1'000'000 ? "" : "bootstrap: must lie in [0, 1000000]";
}

Evaluation evaluate(const Predictor& predictor, const EvaluationSet& whole,
                    const EvaluationOptions& options) {
  Evaluation result;
  EvaluationSet set = whole;
  const TrainOptions& network = predictor.card().options;
  const std::vector<NetworkImage> images = read_images(set, network, options.skip_bad_images, result.skipped);
  if (images.empty()) throw std::runtime_error(set.name + ": no image is left to measure");
  result.set = set.name;
  result.images = judge(predictor, set, images);
  std::vector<int> all(result.images.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  result.network = summary_of(result.images, all, &EvaluatedImage::network);
  result.training_mean = summary_of(result.images, all, &EvaluatedImage::training_mean);
  result.centre = summary_of(result.images, all, &EvaluatedImage::centre);
  result.headline = headline(result.images, all, options);
  result.rays = ray_comparison(predictor, result.images, options);
  result.bins = bins_of(result.images);
  if (options.robustness) {
    const auto picture = [&](std::size_t i) {
      if (!network.orientation.measured) return images[i].gray;
      return measured_picture(read_gray_image(set.images[i].file), images[i].gray.size,
                              network.orientation.max_width);
    };
    result.robustness = robustness(predictor, set, picture, options.seed);
  }
  return result;
}

}  // namespace cps
