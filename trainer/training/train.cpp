#include "trainer/training/train.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "numbers/wall_time.h"
#include "trainer/fit/fit_head.h"
#include "trainer/images/dataset_fingerprint.h"
#include "trainer/model/model_card.h"
#include "trainer/model/predictor.h"
#include "trainer/network/threads.h"
#include "trainer/network/weights.h"
#include "trainer/onnx/export_onnx.h"
#include "trainer/training/distillation.h"
#include "trainer/training/epoch.h"
#include "trainer/training/history.h"
#include "trainer/training/online_images.h"
#include "trainer/training/samples.h"
#include "trainer/training/training_state_file.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

const EpochReport* best_of(const std::vector<EpochReport>& epochs) {
  const auto best = std::ranges::min_element(epochs, {}, &EpochReport::validation_loss);
  return best == epochs.end() ? nullptr : &*best;
}

/// The number of epochs that fit into the given minutes if all last as long as the first.
int epochs_within(double minutes, double elapsed_seconds, double epoch_seconds, int wanted) {
  const double more = (minutes * 60 - elapsed_seconds) / epoch_seconds;
  return std::clamp(1 + static_cast<int>(std::max(0.0, more)), 1, wanted);
}

bool has_lost_patience(int patience, const std::vector<EpochReport>& epochs) {
  return patience > 0 && !epochs.empty() && epochs.back().epoch - best_of(epochs)->epoch >= patience;
}

/// Averages the validation results, so that all processes agree when to stop; otherwise some would wait for
/// ever.
void agree(const Ranks& ranks, EpochReport& report) {
  for (double* number : {&report.validation_loss, &report.validation_cosine, &report.validation_hfov_mae_deg})
    *number = ranks.sum(*number) / ranks.count;
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
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error(fault);
  if (fs::exists(model_folder / "model.json"))
    throw std::runtime_error((model_folder / "model.json").string() +
                             ": a model exists already: continue it with --resume or choose another folder");
  card.options = options;
  card.dataset = dataset.root.string();
  card.dataset_hash = dataset_fingerprint(dataset);
  return card;
}

Samples load_part(const Dataset& dataset, Part part, const TrainOptions& options, const fs::path& cache) {
  return load_samples(dataset, part,
                      {.head = options.head,
                       .space = options.target_space,
                       .reduction = options.reduction,
                       .orientation = options.orientation,
                       .with_rays = options.loss == Loss::reprojection,
                       .skip_bad_images = options.skip_bad_images,
                       .places_share = part == Part::train ? options.places_share : 1},
                      cache);
}

TrainingSet load_training_set(const Dataset& dataset, const TrainOptions& options,
                              const fs::path& model_folder) {
  if (options.online_lenses) return online_images(dataset, options, model_folder / "masters.cache");
  return fixed_images(
      std::make_shared<const Samples>(load_part(dataset, Part::train, options, model_folder / "train.cache")),
      options);
}

}  // namespace

TrainSummary train(const Dataset& dataset, const fs::path& model_folder, const TrainOptions& options,
                   bool resume, const EpochCallback& on_epoch, const Ranks& ranks, Device device) {
  const auto start = std::chrono::steady_clock::now();
  ModelCard card = start_card(dataset, model_folder, options, resume);
  require_learnable(dataset, card.options.head);
  use_threads(card.options.threads);
  if (card.options.batches_per_step % ranks.count != 0)
    throw std::runtime_error("batches-per-step: " + std::to_string(card.options.batches_per_step) +
                             " cannot be divided among " + std::to_string(ranks.count) + " processes");
  const std::unique_ptr<const Predictor> teacher = load_teacher(card.options, device);
  std::error_code error;
  fs::create_directories(model_folder, error);
  if (error) throw std::runtime_error(model_folder.string() + ": cannot be created: " + error.message());

  ranks.wait();                       // until all have checked the folder
  if (ranks.rank != 0) ranks.wait();  // until rank 0 has written the caches
  const TrainingSet training = load_training_set(dataset, card.options, model_folder);
  const Samples validation = load_part(dataset, Part::val, card.options, model_folder / "val.cache");
  if (ranks.rank == 0) ranks.wait();
  TrainSummary summary;
  for (const auto* skipped : {&training.skipped, &validation.skipped})
    summary.skipped.insert(summary.skipped.end(), skipped->begin(), skipped->end());
  summary.decode_seconds = seconds_since(start);
  summary.training_images = card.training_images = static_cast<int>(training.originals.size());
  summary.validation_images = card.validation_images = static_cast<int>(validation.cache.images.size());
  // Inputs and outputs are standardised by the training images alone.
  card.pixels = training.pixels;
  card.orientation = training.orientation;
  card.targets = training.targets;
  card.correlation = training.correlation;
  card.spheres = training.spheres;
  const bool on_cpu = device == Device::cpu;
  const bool computes_bfloat16 = ranks.sum(on_cpu && processor_computes_bfloat16()) == ranks.count;
  card.options.precision = chosen_precision(card.options.precision, computes_bfloat16);
  summary.precision = card.options.precision;
  summary.precision_line = on_cpu ? precision_report(summary.precision, computes_bfloat16)
                                  : "precision " + to_string(summary.precision);

  TrainingState state = resume ? load_training_state(card.options, model_folder / "state.pt")
                               : fresh_training_state(card.options);
  move_to(state, device);
  for (const auto& parameter : state.network->parameters()) summary.parameters += parameter.numel();
  if (!resume && ranks.rank == 0) save_model_card(card, model_folder);

  while (static_cast<int>(state.epochs.size()) < state.planned_epochs &&
         !has_lost_patience(card.options.patience, state.epochs)) {
    const auto epoch_start = std::chrono::steady_clock::now();
    EpochReport report;
    report.epoch = static_cast<int>(state.epochs.size()) + 1;
    train_epoch(state, training, card, teacher.get(), ranks, report);
    const torch::Tensor rows = validate(state.judged(), validation, card, report);
    agree(ranks, report);

    const EpochReport* best = best_of(state.epochs);
    report.is_best = !best || report.validation_loss < best->validation_loss;
    const double epoch_seconds = seconds_since(epoch_start);
    if (card.options.minutes > 0 && report.epoch == 1)
      state.planned_epochs =
          static_cast<int>(ranks.sum(epochs_within(card.options.minutes, seconds_since(start), epoch_seconds,
                                                   state.planned_epochs)) /
                           ranks.count);
    report.planned_epochs = state.planned_epochs;
    report.seconds_left = (state.planned_epochs - report.epoch) * epoch_seconds;
    state.epochs.push_back(report);

    // weights.pt first: a run killed between the two repeats this epoch and writes the same weights again.
    if (report.is_best) {
      card.epoch = report.epoch;
      card.validation_loss = report.validation_loss;
      if (is_fit(card.options.head))
        card.deviation_scale = deviation_scale(rows, validation.targets, card.targets);
    }
    if (ranks.rank == 0) {
      if (report.is_best) {
        fs::remove(model_folder / onnx_file_name);  // of an earlier run: holds other weights
        save_tensors(weights_of(state.judged()), model_folder / "weights.pt");
      }
      save_training_state(state, model_folder / "state.pt");
      save_history(state.epochs, model_folder);
      save_model_card(card, model_folder);
    }

    const bool go_on = !on_epoch || on_epoch(report);
    const bool spent = card.options.minutes > 0 && seconds_since(start) >= card.options.minutes * 60;
    if (ranks.sum(!go_on || spent) > 0) break;
  }
  summary.is_finished = static_cast<int>(state.epochs.size()) >= state.planned_epochs ||
                        has_lost_patience(card.options.patience, state.epochs);
  summary.train_seconds = seconds_since(start) - summary.decode_seconds;
  summary.epochs = state.epochs;
  if (const EpochReport* best = best_of(state.epochs)) summary.best = *best;
  return summary;
}

}  // namespace cps
