#include "trainer/model/train_options.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "trainer/network/architectures.h"

namespace cps {
namespace {

/// The options' names in model.json, in order.
template <typename A, typename Visit>
void for_each_augmentation_key(A& a, Visit visit) {
  visit("probability", a.probability);
  visit("max_blur_sigma_px", a.max_blur_sigma_px);
  visit("max_motion_blur_px", a.max_motion_blur_px);
  visit("max_gamma", a.max_gamma);
  visit("max_iso_noise", a.max_iso_noise);
  visit("min_jpeg_quality", a.min_jpeg_quality);
  visit("max_brightness", a.max_brightness);
  visit("max_contrast", a.max_contrast);
  visit("max_cutout", a.max_cutout);
}

template <typename O, typename Visit>
void for_each_key(O& o, Visit visit) {
  visit("architecture", o.architecture);
  visit("initial_weights", o.initial_weights);
  visit("size_features", o.size_features);
  visit("edge_channel", o.edge_channel);
  visit("orientation", o.orientation);
  visit("head", o.head);
  visit("target_space", o.target_space);
  visit("outputs", o.outputs);
  visit("loss", o.loss);
  visit("width", o.reduction.width);
  visit("factor", o.reduction.factor);
  visit("epochs", o.epochs);
  visit("batch_size", o.batch_size);
  visit("batches_per_step", o.batches_per_step);
  visit("learning_rate", o.learning_rate);
  visit("weight_decay", o.weight_decay);
  visit("warm_up_epochs", o.warm_up_epochs);
  visit("milestones", o.milestones);
  visit("decay", o.decay);
  visit("dropout", o.dropout);
  visit("max_gradient", o.max_gradient);
  visit("skip_bad_images", o.skip_bad_images);
  visit("places_share", o.places_share);
  visit("mirror", o.mirror);
  visit("augmentation", o.augmentation);
  visit("online_lenses", o.online_lenses);
  visit("online_zoom", o.online_zoom);
  visit("teacher", o.teacher);
  visit("teacher_weight", o.teacher_weight);
  visit("ema_decay", o.ema_decay);
  visit("patience", o.patience);
  visit("seed", o.seed);
  visit("threads", o.threads);
  visit("precision", o.precision);
  visit("minutes", o.minutes);
}

/// Options added later: older models lack them.
constexpr std::array later_keys{"online_lenses",  "online_zoom", "edge_channel", "orientation", "teacher",
                                "teacher_weight", "precision",   "head",         "places_share"};

/// An option as JSON: enumerations by name, the augmentation as an object of its own.
template <typename T>
nlohmann::ordered_json json_value(const T& value) {
  return value;
}
nlohmann::ordered_json json_value(Loss value) {
  return to_string(value);
}
nlohmann::ordered_json json_value(Head value) {
  return to_string(value);
}
nlohmann::ordered_json json_value(TargetSpace value) {
  return to_string(value);
}
nlohmann::ordered_json json_value(Precision value) {
  return to_string(value);
}
nlohmann::ordered_json json_value(const OrientationOptions& orientation) {
  return {{"measured", orientation.measured}, {"max_width", orientation.max_width}};
}
nlohmann::ordered_json json_value(const Augmentation& augmentation) {
  nlohmann::ordered_json json;
  for_each_augmentation_key(augmentation, [&](const char* key, const auto& value) { json[key] = value; });
  return json;
}

template <typename T>
void set_value(const nlohmann::json& json, T& value) {
  json.get_to(value);
}
void set_value(const nlohmann::json& json, Loss& value) {
  value = loss_from_string(json.get<std::string>());
}
void set_value(const nlohmann::json& json, Head& value) {
  value = head_from_string(json.get<std::string>());
}
void set_value(const nlohmann::json& json, TargetSpace& value) {
  value = target_space_from_string(json.get<std::string>());
}
void set_value(const nlohmann::json& json, Precision& value) {
  value = precision_from_string(json.get<std::string>());
}
void set_value(const nlohmann::json& json, OrientationOptions& orientation) {
  json.at("measured").get_to(orientation.measured);
  json.at("max_width").get_to(orientation.max_width);
}
void set_value(const nlohmann::json& json, Augmentation& augmentation) {
  for_each_augmentation_key(augmentation, [&](const char* key, auto& value) { json.at(key).get_to(value); });
}

/// What has no meaning for a DeepCalib head.
std::string deepcalib_fault(const TrainOptions& o) {
  const std::string head = "the head " + to_string(o.head);
  if (o.outputs.size() != output_names.size())
    return "outputs: " + head + " learns focal and xi: leave it out";
  if (o.loss != Loss::mse) return "loss: " + head + " has its own: leave it out";
  if (o.online_lenses) return "online-lenses: draws Brown-Conrady lenses, which " + head + " does not learn";
  if (!o.teacher.empty()) return "teacher: " + head + " cannot learn from one";
  return "";
}

/// What a head with a fit needs.
std::string fit_fault(const TrainOptions& o) {
  if (!o.orientation.measured) return "orientation: the head fit needs it: set it";
  if (o.target_space != TargetSpace::seen) return "targets: the head fit needs seen";
  if (o.outputs.size() != output_names.size()) return "outputs: the head fit learns all eight: leave it out";
  if (!find_architecture(o.architecture)->max_pool)
    return "arch " + o.architecture + ": the head fit needs an architecture that pools after its first layer";
  return "";
}

}  // namespace

std::string to_string(Loss loss) {
  return loss == Loss::mse ? "mse" : loss == Loss::huber ? "huber" : "reprojection";
}

Loss loss_from_string(const std::string& word) {
  for (Loss loss : {Loss::mse, Loss::huber, Loss::reprojection})
    if (word == to_string(loss)) return loss;
  throw std::runtime_error("loss '" + word + "': unknown: use mse, huber or reprojection");
}

std::string TrainOptions::fault() const {
  if (!find_architecture(architecture)) {
    std::string known;
    for (const Architecture& a : architectures()) known += " " + a.name;
    return "arch '" + architecture + "': unknown: choose one of" + known;
  }
  if (outputs.empty()) return "outputs: name at least one";
  for (const std::string& name : outputs)
    if (std::ranges::find(output_names, name) == output_names.end())
      return "outputs: '" + name + "' is none of fov k1 k2 k3 p1 p2 cx cy";
  if (loss == Loss::reprojection && outputs.size() != output_names.size())
    return "loss: reprojection needs all eight outputs";
  if (loss == Loss::reprojection && target_space == TargetSpace::seen)
    return "loss: reprojection needs targets apparent or raw";
  if (is_fit(head))
    if (const std::string fault = fit_fault(*this); !fault.empty()) return fault;
  if (is_deepcalib(head))
    if (const std::string fault = deepcalib_fault(*this); !fault.empty()) return fault;
  if (reduction.factor < 0) return "reduce: must not be negative";
  if (reduction.factor == 0 && reduction.width < 32) return "width: must be at least 32 pixels";
  if (epochs < 1) return "epochs: must be at least 1";
  if (batch_size < 2) return "batch: must be at least 2 (batch normalisation)";
  if (batches_per_step < 1 || batches_per_step > 4096) return "batches-per-step: must lie in [1, 4096]";
  if (!(learning_rate > 0 && learning_rate < 1)) return "lr: must lie between 0 and 1";
  if (!(weight_decay >= 0 && weight_decay < 1)) return "weight-decay: must lie in [0, 1)";
  if (!(warm_up_epochs >= 0)) return "warm-up: must not be negative";
  for (double m : milestones)
    if (!(m > 0 && m <= 1)) return "milestones: each must lie in (0, 1]";
  if (!(decay > 0 && decay <= 1)) return "decay: must lie in (0, 1]";
  if (!(dropout >= 0 && dropout < 1)) return "dropout: must lie in [0, 1)";
  if (!(max_gradient >= 0)) return "max-gradient: must not be negative";
  if (!(places_share > 0 && places_share <= 1)) return "places-share: must be above 0 and at most 1";
  if (const std::string fault = augmentation.fault(); !fault.empty()) return fault;
  if (const std::string fault = orientation.fault(); !fault.empty()) return fault;
  if (!(online_zoom >= 1 && online_zoom <= 3)) return "online-zoom: must lie in [1, 3]";
  if (!(teacher_weight >= 0 && teacher_weight <= 1)) return "teacher-weight: must lie in [0, 1]";
  if (!(ema_decay >= 0 && ema_decay < 1)) return "ema: must lie in [0, 1)";
  if (patience < 0) return "patience: must not be negative";
  if (threads < 0) return "threads: must not be negative";
  if (!(minutes >= 0)) return "minutes: must not be negative";
  return "";
}

nlohmann::ordered_json to_json(const TrainOptions& options) {
  nlohmann::ordered_json json;
  for_each_key(options, [&](const char* key, const auto& value) {
    const bool is_left_out =
        (key == std::string_view("orientation") && !options.orientation.measured) ||
        (key == std::string_view("precision") && options.precision == Precision::float32) ||
        (key == std::string_view("head") && options.head == Head::brown_conrady) ||
        (key == std::string_view("places_share") && options.places_share == 1);
    if (!is_left_out) json[key] = json_value(value);
  });
  return json;
}

TrainOptions train_options_from_json(const nlohmann::json& json) {
  TrainOptions options;
  for_each_key(options, [&](const char* key, auto& value) {
    if (json.contains(key) || std::ranges::find(later_keys, std::string_view(key)) == later_keys.end())
      set_value(json.at(key), value);
  });
  return options;
}

double learning_rate_at(const TrainOptions& options, double progress, int planned_epochs) {
  double rate = options.learning_rate;
  if (progress < options.warm_up_epochs) rate *= progress / options.warm_up_epochs;
  for (double milestone : options.milestones)
    if (progress >= milestone * planned_epochs) rate *= options.decay;
  return rate;
}

}  // namespace cps
