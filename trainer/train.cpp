#include "trainer/train.h"

#include <torch/nn/module.h>
#include <torch/nn/utils/clip_grad.h>
#include <torch/utils.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "dataset/files.h"
#include "random/counter_hash.h"
#include "trainer/batches.h"
#include "trainer/inference.h"
#include "trainer/model_card.h"
#include "trainer/samples.h"
#include "trainer/threads.h"
#include "trainer/training_state.h"

namespace cps {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

torch::Tensor target_tensor(const Samples& samples, const std::vector<int>& batch,
                            const std::vector<BatchImage>& members, const Standardisation& by) {
  torch::Tensor tensor = torch::empty({static_cast<long>(batch.size()), output_count});
  float* out = tensor.data_ptr<float>();
  for (std::size_t n = 0; n < batch.size(); ++n)
    for (double v :
         standardise((members[n].mirror ? samples.mirrored_targets : samples.targets)[batch[n]], by))
      *out++ = static_cast<float>(v);
  return tensor;
}

/// One pass over the training images; fills in the report's learning rate, loss and rate.
void train_epoch(TrainingState& state, const Samples& samples, const ModelCard& card, EpochReport& report) {
  const TrainOptions& options = card.options;
  const auto start = Clock::now();
  state.network->train();
  torch::manual_seed(random_bits(make_stream(options.seed, "dropout"), report.epoch));
  const auto batches =
      shuffled_batches(samples.cache.originals, options.batch_size, options.seed, report.epoch);
  double loss_sum = 0;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const double progress = report.epoch - 1 + (b + 1.0) / batches.size();
    report.learning_rate = learning_rate_at(options, progress, state.planned_epochs);
    static_cast<torch::optim::AdamWOptions&>(state.optimizer->param_groups()[0].options())
        .lr(report.learning_rate);

    std::vector<BatchImage> members;
    for (int i : batches[b])
      members.push_back({samples.cache.images[i], samples.cache.originals[i],
                         options.mirror && is_mirrored(options.seed, report.epoch, i)});
    const torch::Tensor said =
        state.network->forward(image_tensor(members, card.pixels), size_tensor(members));
    const torch::Tensor loss =
        torch::mse_loss(said, target_tensor(samples, batches[b], members, card.targets));
    state.optimizer->zero_grad();
    loss.backward();
    if (options.max_gradient > 0)
      torch::nn::utils::clip_grad_norm_(state.network->parameters(), options.max_gradient);
    state.optimizer->step();
    loss_sum += loss.item<double>() * static_cast<double>(batches[b].size());
  }
  const double images = static_cast<double>(samples.targets.size());
  report.training_loss = loss_sum / images;
  report.images_per_second = images / seconds_since(start);
}

double cosine_similarity(const Outputs& a, const Outputs& b) {
  double ab = 0, aa = 0, bb = 0;
  for (int i = 0; i < output_count; ++i) {
    ab += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return ab / std::max(std::sqrt(aa * bb), 1e-12);
}

void validate(Network& network, const Samples& samples, const ModelCard& card, EpochReport& report) {
  std::vector<BatchImage> images;
  for (std::size_t i = 0; i < samples.targets.size(); ++i)
    images.push_back({samples.cache.images[i], samples.cache.originals[i]});
  const std::vector<Outputs> said = run_network(network, images, card.pixels, card.options.batch_size);
  for (std::size_t i = 0; i < said.size(); ++i) {
    const Outputs truth = standardise(samples.targets[i], card.targets);
    double squares = 0;
    for (int k = 0; k < output_count; ++k) squares += (said[i][k] - truth[k]) * (said[i][k] - truth[k]);
    report.validation_loss += squares / output_count;
    report.validation_cosine += cosine_similarity(said[i], truth);
    report.validation_hfov_mae_deg += degrees(std::abs(said[i][0] - truth[0]) * card.targets.deviation[0]);
  }
  const double n = static_cast<double>(said.size());
  report.validation_loss /= n;
  report.validation_cosine /= n;
  report.validation_hfov_mae_deg /= n;
}

void save_history(const std::vector<EpochReport>& epochs, const fs::path& file) {
  std::string csv =
      "epoch,learning_rate,training_loss,validation_loss,validation_cosine,validation_hfov_mae_deg,images_"
      "per_second\n";
  char line[256];
  for (const EpochReport& r : epochs) {
    std::snprintf(line, sizeof line, "%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.4g\n", r.epoch, r.learning_rate,
                  r.training_loss, r.validation_loss, r.validation_cosine, r.validation_hfov_mae_deg,
                  r.images_per_second);
    csv += line;
  }
  write_file(file, csv);
}

const EpochReport* best_of(const std::vector<EpochReport>& epochs) {
  const auto best = std::ranges::min_element(epochs, {}, &EpochReport::validation_loss);
  return best == epochs.end() ? nullptr : &*best;
}

/// As many epochs as fit into what is left of the budget, judging by the first.
int epochs_within(double minutes, double elapsed_seconds, double epoch_seconds, int wanted) {
  const double more = (minutes * 60 - elapsed_seconds) / epoch_seconds;
  return std::clamp(1 + static_cast<int>(std::max(0.0, more)), 1, wanted);
}

ModelCard start_card(const Dataset& dataset, const fs::path& model_folder, const TrainOptions& options,
                     bool resume) {
  ModelCard card;
  if (resume) {
    card = load_model_card(model_folder);
    if (card.dataset_hash != dataset_fingerprint(dataset))
      throw std::runtime_error((model_folder / "model.json").string() + ": was trained on " + card.dataset +
                               ", whose images or labels are not those of " + dataset.root.string() +
                               ": resume with the same dataset");
    return card;
  }
  std::string why;
  if (!options.is_valid(&why)) throw std::runtime_error(why);
  if (fs::exists(model_folder / "model.json"))
    throw std::runtime_error((model_folder / "model.json").string() +
                             ": a model is there already: go on with --resume or choose another folder");
  card.options = options;
  card.dataset = dataset.root.string();
  card.dataset_hash = dataset_fingerprint(dataset);
  return card;
}

}  // namespace

TrainSummary train(const Dataset& dataset, const fs::path& model_folder, const TrainOptions& options,
                   bool resume, const EpochCallback& on_epoch) {
  const auto start = Clock::now();
  ModelCard card = start_card(dataset, model_folder, options, resume);
  use_threads(card.options.threads);
  std::error_code error;
  fs::create_directories(model_folder, error);
  if (error)
    throw std::runtime_error(model_folder.string() + ": cannot be made a folder: " + error.message());

  const auto load = [&](Part part, const char* cache) {
    return load_samples(dataset, part, card.options.target_space, card.options.reduction,
                        model_folder / cache);
  };
  const Samples training = load(Part::train, "train.cache"), validation = load(Part::val, "val.cache");
  TrainSummary summary;
  summary.decode_seconds = seconds_since(start);
  summary.training_images = card.training_images = static_cast<int>(training.targets.size());
  summary.validation_images = card.validation_images = static_cast<int>(validation.targets.size());

  // What the network is shown and asked is standardised by the training images alone.
  card.pixels = pixel_statistics(training.cache.images);
  std::vector<Outputs> targets = training.targets;
  if (card.options.mirror)
    targets.insert(targets.end(), training.mirrored_targets.begin(), training.mirrored_targets.end());
  card.targets = fit_standardisation(targets);

  TrainingState state = resume ? load_training_state(card.options, model_folder / "state.pt")
                               : fresh_training_state(card.options);
  for (const auto& parameter : state.network->parameters()) summary.parameters += parameter.numel();
  if (!resume) save_model_card(card, model_folder);

  while (static_cast<int>(state.epochs.size()) < state.planned_epochs) {
    const auto epoch_start = Clock::now();
    EpochReport report;
    report.epoch = static_cast<int>(state.epochs.size()) + 1;
    train_epoch(state, training, card, report);
    validate(*state.network, validation, card, report);

    const EpochReport* best = best_of(state.epochs);
    report.is_best = !best || report.validation_loss < best->validation_loss;
    const double epoch_seconds = seconds_since(epoch_start);
    if (card.options.minutes > 0 && report.epoch == 1)
      state.planned_epochs =
          epochs_within(card.options.minutes, seconds_since(start), epoch_seconds, state.planned_epochs);
    report.planned_epochs = state.planned_epochs;
    report.seconds_left = (state.planned_epochs - report.epoch) * epoch_seconds;
    state.epochs.push_back(report);

    // weights.pt first: a run killed in between repeats this epoch and writes the same weights again.
    if (report.is_best) {
      save_tensors(weights_of(*state.network), model_folder / "weights.pt");
      card.epoch = report.epoch;
      card.validation_loss = report.validation_loss;
    }
    save_training_state(state, model_folder / "state.pt");
    save_history(state.epochs, model_folder / "history.csv");
    save_model_card(card, model_folder);

    const bool go_on = !on_epoch || on_epoch(report);
    const bool spent = card.options.minutes > 0 && seconds_since(start) >= card.options.minutes * 60;
    if (!go_on || spent) break;
  }
  summary.is_finished = static_cast<int>(state.epochs.size()) >= state.planned_epochs;
  summary.train_seconds = seconds_since(start) - summary.decode_seconds;
  summary.epochs = state.epochs;
  if (const EpochReport* best = best_of(state.epochs)) summary.best = *best;
  return summary;
}

}  // namespace cps
