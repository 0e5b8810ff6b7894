#include "trainer/training/epoch.h"

#include <torch/nn/utils/clip_grad.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "numbers/angles.h"
#include "numbers/wall_time.h"
#include "random/counter_hash.h"
#include "trainer/deepcalib/sphere_head.h"
#include "trainer/fit/fit_head.h"
#include "trainer/images/batches.h"
#include "trainer/network/inference.h"
#include "trainer/training/batch_loader.h"
#include "trainer/training/batch_loss.h"
#include "trainer/training/distillation.h"
#include "trainer/training/step_sums.h"

namespace cps {
namespace {

BatchTruth truth_of(const std::vector<ShownImage>& shown) {
  BatchTruth truth{.size = shown.front().original, .targets = {}, .rays = {}};
  for (const ShownImage& image : shown) {
    truth.targets.push_back(image.target);
    truth.spheres.push_back(image.sphere);
    if (image.rays) truth.rays.push_back(image.rays);
  }
  return truth;
}

BatchTruth truth_of(const Samples& samples, const Batch& batch) {
  BatchTruth truth{.size = samples.cache.originals[batch.front()], .targets = {}, .rays = {}};
  for (int i : batch) {
    if (!samples.targets.empty()) truth.targets.push_back(samples.targets[i]);
    if (!samples.spheres.empty()) truth.spheres.push_back(samples.spheres[i]);
    if (!samples.rays.empty()) truth.rays.push_back(samples.rays[i]);
  }
  return truth;
}

/// Over the learned outputs.
double cosine_similarity(const Outputs& a, const Outputs& b, const std::vector<int>& learned) {
  double ab = 0, aa = 0, bb = 0;
  for (int i : learned) {
    ab += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return ab / std::max(std::sqrt(aa * bb), 1e-12);
}

std::vector<int> learned_outputs(const TrainOptions& options) {
  std::vector<int> learned;
  for (int i = 0; i < output_count; ++i)
    if (std::ranges::find(options.outputs, output_names[i]) != options.outputs.end()) learned.push_back(i);
  return learned;
}

/// Mean cosine similarity and error of the label's H-FOV of a Brown–Conrady head's outputs, the first eight
/// numbers of the rows.
void judge_outputs(const torch::Tensor& rows, const Samples& samples, const ModelCard& card,
                   EpochReport& report) {
  const auto numbers = rows.accessor<float, 2>();
  const double n = static_cast<double>(samples.targets.size());
  const std::vector<int> learned = learned_outputs(card.options);
  const auto hfov_rad = [&](const Outputs& outputs, const ImageSize& size) {
    return convert(outputs, card.options.target_space, TargetSpace::raw, size.width, size.height)[0];
  };
  for (std::size_t i = 0; i < samples.targets.size(); ++i) {
    const Outputs truth = standardise(samples.targets[i], card.targets);
    Outputs predicted;
    for (int k = 0; k < output_count; ++k) predicted[k] = numbers[static_cast<long>(i)][k];
    report.validation_cosine += cosine_similarity(predicted, truth, learned) / n;
    const ImageSize& size = samples.cache.originals[i];
    report.validation_hfov_mae_deg +=
        degrees(std::abs(hfov_rad(unstandardise(predicted, card.targets), size) -
                         hfov_rad(samples.targets[i], size))) /
        n;
  }
}

/// The same of the outputs of a DeepCalib head: the similarity of deviations from the training mean, and the
/// error of the H-FOV that is seen.
void judge_spheres(const torch::Tensor& rows, const Samples& samples, const ModelCard& card,
                   EpochReport& report) {
  const std::vector<SphereTarget> predicted = sphere_targets(card.options.head, rows);
  const double n = static_cast<double>(predicted.size());
  const auto standardised = [&](const SphereTarget& target) {
    const auto& [mean, deviation] = card.spheres;
    return Outputs{(target.focal - mean.focal) / deviation.focal, (target.xi - mean.xi) / deviation.xi};
  };
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const SphereTarget& truth = samples.spheres[i];
    report.validation_cosine +=
        cosine_similarity(standardised(predicted[i]), standardised(truth), {0, 1}) / n;
    const int width = samples.cache.originals[i].width;
    report.validation_hfov_mae_deg +=
        degrees(std::abs(seen_hfov_rad(predicted[i], width) - seen_hfov_rad(truth, width))) / n;
  }
}

}  // namespace

void train_epoch(TrainingState& state, const TrainingSet& set, const ModelCard& card,
                 const Predictor* teacher, const Ranks& ranks, EpochReport& report) {
  const TrainOptions& options = card.options;
  const auto start = std::chrono::steady_clock::now();
  state.network->train();
  const Stream noise = substream(make_stream(options.seed, "dropout"), report.epoch);
  const auto batches = shuffled_batches(set.originals, options.batch_size, options.seed, report.epoch);
  const std::size_t per_step = options.batches_per_step, steps = (batches.size() + per_step - 1) / per_step;
  // Those that this process computes: every step's number of batches is a multiple of that of the processes.
  std::vector<Batch> own;
  for (std::size_t b = ranks.rank; b < batches.size(); b += ranks.count) own.push_back(batches[b]);
  BatchLoader loader(set, std::move(own), card, report.epoch);
  const torch::Device device = state.network->device();
  std::vector<torch::Tensor> parameters = state.network->parameters();
  double loss_sum = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    const double progress = report.epoch - 1 + (step + 1.0) / steps;
    report.learning_rate = learning_rate_at(options, progress, state.planned_epochs);
    static_cast<torch::optim::AdamWOptions&>(state.optimizer->param_groups()[0].options())
        .lr(report.learning_rate);

    std::optional<StepSums> sums;  // with several batches per step, the processes divide them
    if (per_step > 1) sums.emplace(*state.network);
    const std::size_t end = std::min(batches.size(), (step + 1) * per_step);
    for (std::size_t b = step * per_step + ranks.rank; b < end; b += ranks.count) {
      if (sums) sums->begin_batch();
      torch::manual_seed(random_bits(noise, b));
      const LoadedBatch batch = loader.next();
      const NetworkOutput output = state.network->forward(batch.pixels.to(device), batch.sizes.to(device),
                                                          batch.orientation.to(device));
      const torch::Tensor predicted = head_rows(output, batch.images, card);
      torch::Tensor loss = batch_loss(predicted, truth_of(batch.shown), card);
      if (teacher) {
        const double share = options.teacher_weight;
        loss = loss * (1 - share) + distillation_loss(predicted, *teacher, batch.images, card) * share;
      }
      // Reset rather than zeroed: backward() then stores gradients instead of adding them.
      for (torch::Tensor& parameter : parameters) parameter.mutable_grad().reset();
      loss.backward();
      const double loss_of_images = loss.item<double>() * static_cast<double>(batch.shown.size());
      if (sums)
        sums->add_batch(loss_of_images);
      else
        loss_sum += loss_of_images;
    }
    if (sums) loss_sum += sums->finish(ranks);
    if (options.max_gradient > 0) torch::nn::utils::clip_grad_norm_(parameters, options.max_gradient);
    state.optimizer->step();
    ++state.steps;
    update_average(state, options.ema_decay);
  }
  const double images = static_cast<double>(set.originals.size());
  report.training_loss = loss_sum / images;
  const double seconds = seconds_since(start);
  report.images_per_second = images / seconds;
  report.loader_share = loader.waited_seconds() / seconds;
}

torch::Tensor validate(Network& network, const Samples& samples, const ModelCard& card, EpochReport& report) {
  std::vector<BatchImage> images;
  for (std::size_t i = 0; i < samples.cache.images.size(); ++i)
    images.push_back(
        {samples.cache.images[i], samples.cache.originals[i], false, samples.cache.orientations[i]});
  const torch::Tensor rows = run_head(network, images, card);
  const double n = static_cast<double>(images.size());
  for (const Batch& batch : ordered_batches(samples.cache.originals, card.options.batch_size)) {
    const std::vector<std::int64_t> members(batch.begin(), batch.end());
    const torch::Tensor predicted = rows.index_select(0, torch::tensor(members, torch::kLong));
    report.validation_loss += batch_loss(predicted, truth_of(samples, batch), card).item<double>() *
                              static_cast<double>(batch.size()) / n;
  }
  if (is_deepcalib(card.options.head))
    judge_spheres(rows, samples, card, report);
  else
    judge_outputs(rows, samples, card, report);
  return rows;
}

}  // namespace cps
