#include "trainer/train_options.h"

#include <algorithm>
#include <stdexcept>

#include "trainer/architectures.h"

namespace cps {
namespace {

nlohmann::ordered_json to_json(const Augmentation& a) {
  return {{"probability", a.probability},
          {"max_blur_sigma_px", a.max_blur_sigma_px},
          {"max_motion_blur_px", a.max_motion_blur_px},
          {"max_gamma", a.max_gamma},
          {"max_iso_noise", a.max_iso_noise},
          {"min_jpeg_quality", a.min_jpeg_quality},
          {"max_brightness", a.max_brightness},
          {"max_contrast", a.max_contrast},
          {"max_cutout", a.max_cutout}};
}

Augmentation augmentation_from_json(const nlohmann::json& json) {
  Augmentation a;
  json.at("probability").get_to(a.probability);
  json.at("max_blur_sigma_px").get_to(a.max_blur_sigma_px);
  json.at("max_motion_blur_px").get_to(a.max_motion_blur_px);
  json.at("max_gamma").get_to(a.max_gamma);
  json.at("max_iso_noise").get_to(a.max_iso_noise);
  json.at("min_jpeg_quality").get_to(a.min_jpeg_quality);
  json.at("max_brightness").get_to(a.max_brightness);
  json.at("max_contrast").get_to(a.max_contrast);
  json.at("max_cutout").get_to(a.max_cutout);
  return a;
}

}  // namespace

std::string to_string(Loss loss) {
  return loss == Loss::mse ? "mse" : loss == Loss::huber ? "huber" : "reprojection";
}

Loss loss_from_string(const std::string& word) {
  for (Loss loss : {Loss::mse, Loss::huber, Loss::reprojection})
    if (word == to_string(loss)) return loss;
  throw std::runtime_error("loss '" + word + "': not known: say mse, huber or reprojection");
}

bool TrainOptions::is_valid(std::string* why) const {
  const auto refuse = [&](const std::string& reason) {
    if (why) *why = reason;
    return false;
  };
  if (!find_architecture(architecture)) {
    std::string known;
    for (const Architecture& a : architectures()) known += " " + a.name;
    return refuse("arch '" + architecture + "': not known: choose one of" + known);
  }
  if (outputs.empty()) return refuse("outputs: name at least one");
  for (const std::string& name : outputs)
    if (std::ranges::find(output_names, name) == output_names.end())
      return refuse("outputs: '" + name + "' is none of fov k1 k2 k3 p1 p2 cx cy");
  if (loss == Loss::reprojection && outputs.size() != output_names.size())
    return refuse("loss: reprojection needs all eight outputs");
  if (reduction.factor < 0) return refuse("reduce: must not be negative");
  if (reduction.factor == 0 && reduction.width < 32) return refuse("width: must be at least 32 pixels");
  if (epochs < 1) return refuse("epochs: must be at least 1");
  if (batch_size < 2) return refuse("batch: must be at least 2 (batch normalisation)");
  if (batches_per_step < 1 || batches_per_step > 4096)
    return refuse("batches-per-step: must lie in [1, 4096]");
  if (!(learning_rate > 0 && learning_rate < 1)) return refuse("lr: must lie between 0 and 1");
  if (!(weight_decay >= 0 && weight_decay < 1)) return refuse("weight-decay: must lie in [0, 1)");
  if (!(warm_up_epochs >= 0)) return refuse("warm-up: must not be negative");
  for (double m : milestones)
    if (!(m > 0 && m <= 1)) return refuse("milestones: each must lie in (0, 1]");
  if (!(decay > 0 && decay <= 1)) return refuse("decay: must lie in (0, 1]");
  if (!(dropout >= 0 && dropout < 1)) return refuse("dropout: must lie in [0, 1)");
  if (!(max_gradient >= 0)) return refuse("max-gradient: must not be negative");
  if (!augmentation.is_valid(why)) return false;
  if (!(ema_decay >= 0 && ema_decay < 1)) return refuse("ema: must lie in [0, 1)");
  if (patience < 0) return refuse("patience: must not be negative");
  if (threads < 0) return refuse("threads: must not be negative");
  if (!(minutes >= 0)) return refuse("minutes: must not be negative");
  return true;
}

nlohmann::ordered_json to_json(const TrainOptions& o) {
  return {{"architecture", o.architecture},
          {"initial_weights", o.initial_weights},
          {"size_features", o.size_features},
          {"target_space", to_string(o.target_space)},
          {"outputs", o.outputs},
          {"loss", to_string(o.loss)},
          {"width", o.reduction.width},
          {"factor", o.reduction.factor},
          {"epochs", o.epochs},
          {"batch_size", o.batch_size},
          {"batches_per_step", o.batches_per_step},
          {"learning_rate", o.learning_rate},
          {"weight_decay", o.weight_decay},
          {"warm_up_epochs", o.warm_up_epochs},
          {"milestones", o.milestones},
          {"decay", o.decay},
          {"dropout", o.dropout},
          {"max_gradient", o.max_gradient},
          {"skip_bad_images", o.skip_bad_images},
          {"mirror", o.mirror},
          {"augmentation", to_json(o.augmentation)},
          {"ema_decay", o.ema_decay},
          {"patience", o.patience},
          {"seed", o.seed},
          {"threads", o.threads},
          {"minutes", o.minutes}};
}

TrainOptions train_options_from_json(const nlohmann::json& json) {
  TrainOptions o;
  json.at("architecture").get_to(o.architecture);
  json.at("initial_weights").get_to(o.initial_weights);
  json.at("size_features").get_to(o.size_features);
  json.at("outputs").get_to(o.outputs);
  o.loss = loss_from_string(json.at("loss").get<std::string>());
  o.target_space = target_space_from_string(json.at("target_space").get<std::string>());
  json.at("width").get_to(o.reduction.width);
  json.at("factor").get_to(o.reduction.factor);
  json.at("epochs").get_to(o.epochs);
  json.at("batch_size").get_to(o.batch_size);
  json.at("batches_per_step").get_to(o.batches_per_step);
  json.at("learning_rate").get_to(o.learning_rate);
  json.at("weight_decay").get_to(o.weight_decay);
  json.at("warm_up_epochs").get_to(o.warm_up_epochs);
  json.at("milestones").get_to(o.milestones);
  json.at("decay").get_to(o.decay);
  json.at("dropout").get_to(o.dropout);
  json.at("max_gradient").get_to(o.max_gradient);
  json.at("skip_bad_images").get_to(o.skip_bad_images);
  json.at("mirror").get_to(o.mirror);
  o.augmentation = augmentation_from_json(json.at("augmentation"));
  json.at("ema_decay").get_to(o.ema_decay);
  json.at("patience").get_to(o.patience);
  json.at("seed").get_to(o.seed);
  json.at("threads").get_to(o.threads);
  json.at("minutes").get_to(o.minutes);
  return o;
}

double learning_rate_at(const TrainOptions& options, double progress, int planned_epochs) {
  double rate = options.learning_rate;
  if (progress < options.warm_up_epochs) rate *= progress / options.warm_up_epochs;
  for (double milestone : options.milestones)
    if (progress >= milestone * planned_epochs) rate *= options.decay;
  return rate;
}

}  // namespace cps
