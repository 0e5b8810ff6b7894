#include "trainer/evaluation/evaluate.h"

#include <tbb/parallel_for.h>

#include <stdexcept>
#include <utility>

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

/// They point into `images`.
std::vector<BatchImage> batch_of(const EvaluationSet& set, const std::vector<NetworkImage>& images) {
  std::vector<BatchImage> batch;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Pinhole& camera = set.images[i].truth.pinhole;
    batch.push_back(batch_image(images[i], {camera.width, camera.height}));
  }
  return batch;
}

std::vector<EvaluatedImage> judge(const Predictor& predictor, const EvaluationSet& set,
                                  std::span<const BatchImage> batch) {
  const ModelCard& card = predictor.card();
  const TargetSpace space = card.options.target_space;
  std::vector<Outputs> predicted;
  std::vector<LensPosterior> posteriors;
  if (is_fit(card.options.head)) {
    posteriors = predictor.posteriors(batch);
    for (const LensPosterior& posterior : posteriors) predicted.push_back(posterior.mean);
  } else {
    predicted = predictor(batch);
  }
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
                 errors(centred_without_distortion(raw(card.targets.mean)[0], camera))};
    if (posteriors.empty()) return;
    const auto deviation = [&](TargetSpace to) {
      return convert(posteriors[i], space, to, camera.width, camera.height).deviation();
    };
    judged[i].deviation = deviation(TargetSpace::raw);
    judged[i].apparent_deviation = deviation(TargetSpace::apparent);
  });
  return judged;
}

/// Of the chosen images' k1 in apparent space, which is true_k1[i] for image i; repeated ones count
/// repeatedly.
double k1_r2(const std::vector<EvaluatedImage>& images, std::span<const double> true_k1,
             std::span<const int> chosen) {
  std::vector<double> truth, error;
  for (int i : chosen) {
    truth.push_back(true_k1[i]);
    error.push_back(images[i].network.apparent[1]);
  }
  return r_squared(truth, error);
}

Headline headline(const std::vector<EvaluatedImage>& images, std::span<const int> all,
                  const EvaluationOptions& options) {
  std::vector<int> clusters;
  std::vector<double> true_k1;
  for (const EvaluatedImage& image : images) {
    clusters.push_back(image.image.cluster);
    true_k1.push_back(to_outputs(image.image.truth, TargetSpace::apparent)[1]);
  }
  const auto numbers = [&](std::span<const int> chosen) {
    const LensErrors network = summary_of(images, chosen, &EvaluatedImage::network),
                     mean = summary_of(images, chosen, &EvaluatedImage::training_mean);
    return std::vector{network.hfov_mean_deg,
                       network.hfov_median_deg,
                       network.hfov_correlation,
                       network.reprojection_mean_px,
                       network.reprojection_median_px,
                       network.hfov_mean_deg / mean.hfov_mean_deg,
                       network.reprojection_mean_px / mean.reprojection_mean_px,
                       k1_r2(images, true_k1, chosen)};
  };
  const std::vector<double> value = numbers(all);
  const std::vector<Interval> interval =
      bootstrap_intervals(clusters, numbers, options.resamples, make_stream(options.seed, "bootstrap"));
  const auto estimate = [&](int i) { return Estimate{value[i], interval[i]}; };
  return {estimate(0), estimate(1), estimate(2), estimate(3),
          estimate(4), estimate(5), estimate(6), estimate(7)};
}

RayComparison ray_comparison(const Predictor& predictor, const std::vector<EvaluatedImage>& images,
                             const EvaluationOptions& options) {
  std::vector<RayErrors> network(images.size()), mean(images.size());
  std::vector<int> clusters;
  std::vector<std::string> cameras;
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    const EvaluationImage& image = images[i].image;
    const ImageSize size{image.truth.pinhole.width, image.truth.pinhole.height};
    network[i] = ray_errors(*image.ray_truth, predicted_camera(images[i].predicted, TargetSpace::raw, size));
    mean[i] = ray_errors(*image.ray_truth, training_mean_camera(predictor.card(), size));
  });
  for (const EvaluatedImage& image : images) {
    clusters.push_back(image.image.cluster);
    cameras.push_back(image.image.camera);
  }
  return compare_rays(network, mean, clusters, cameras, options.resamples, options.seed);
}

std::optional<Coverage> stated_coverage(const std::vector<EvaluatedImage>& images) {
  if (!images.front().deviation) return std::nullopt;
  std::vector<Outputs> errors, deviations;
  for (const EvaluatedImage& image : images) {
    errors.push_back(image.network.raw);
    deviations.push_back(*image.deviation);
  }
  return coverage_of(errors, deviations);
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
  const std::vector<BatchImage> batch = batch_of(set, images);
  result.images = judge(predictor, set, batch);
  std::vector<int> all(result.images.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  result.network = summary_of(result.images, all, &EvaluatedImage::network);
  result.training_mean = summary_of(result.images, all, &EvaluatedImage::training_mean);
  result.centre = summary_of(result.images, all, &EvaluatedImage::centre);
  result.headline = headline(result.images, all, options);
  result.rays = ray_comparison(predictor, result.images, options);
  result.coverage = stated_coverage(result.images);
  result.bins = bins_of(result.images, options.resamples, options.seed);
  if (is_fit(network.head)) result.edges = trusted_edges(predictor, result.images, batch);
  if (options.per_camera) result.cameras = evaluate_cameras(predictor, result.images, batch);
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
