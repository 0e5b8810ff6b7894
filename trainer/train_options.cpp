#include "trainer/train_options.h"

#include "trainer/architectures.h"

namespace cps {

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
  if (reduction.factor < 0) return refuse("reduce: must not be negative");
  if (reduction.factor == 0 && reduction.width < 32) return refuse("width: must be at least 32 pixels");
  if (epochs < 1) return refuse("epochs: must be at least 1");
  if (batch_size < 2) return refuse("batch: must be at least 2 (batch normalisation)");
  if (!(learning_rate > 0 && learning_rate < 1)) return refuse("lr: must lie between 0 and 1");
  if (!(weight_decay >= 0 && weight_decay < 1)) return refuse("weight-decay: must lie in [0, 1)");
  if (!(warm_up_epochs >= 0)) return refuse("warm-up: must not be negative");
  for (double m : milestones)
    if (!(m > 0 && m <= 1)) return refuse("milestones: each must lie in (0, 1]");
  if (!(decay > 0 && decay <= 1)) return refuse("decay: must lie in (0, 1]");
  if (!(dropout >= 0 && dropout < 1)) return refuse("dropout: must lie in [0, 1)");
  if (!(max_gradient >= 0)) return refuse("max-gradient: must not be negative");
  if (threads < 0) return refuse("threads: must not be negative");
  if (!(minutes >= 0)) return refuse("minutes: must not be negative");
  return true;
}

nlohmann::ordered_json to_json(const TrainOptions& o) {
  return {{"architecture", o.architecture},
          {"target_space", to_string(o.target_space)},
          {"width", o.reduction.width},
          {"factor", o.reduction.factor},
          {"epochs", o.epochs},
          {"batch_size", o.batch_size},
          {"learning_rate", o.learning_rate},
          {"weight_decay", o.weight_decay},
          {"warm_up_epochs", o.warm_up_epochs},
          {"milestones", o.milestones},
          {"decay", o.decay},
          {"dropout", o.dropout},
          {"max_gradient", o.max_gradient},
          {"mirror", o.mirror},
          {"seed", o.seed},
          {"threads", o.threads},
          {"minutes", o.minutes}};
}

TrainOptions train_options_from_json(const nlohmann::json& json) {
  TrainOptions o;
  json.at("architecture").get_to(o.architecture);
  o.target_space = target_space_from_string(json.at("target_space").get<std::string>());
  json.at("width").get_to(o.reduction.width);
  json.at("factor").get_to(o.reduction.factor);
  json.at("epochs").get_to(o.epochs);
  json.at("batch_size").get_to(o.batch_size);
  json.at("learning_rate").get_to(o.learning_rate);
  json.at("weight_decay").get_to(o.weight_decay);
  json.at("warm_up_epochs").get_to(o.warm_up_epochs);
  json.at("milestones").get_to(o.milestones);
  json.at("decay").get_to(o.decay);
  json.at("dropout").get_to(o.dropout);
  json.at("max_gradient").get_to(o.max_gradient);
  json.at("mirror").get_to(o.mirror);
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
