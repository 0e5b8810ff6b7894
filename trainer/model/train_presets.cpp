#include "trainer/model/train_presets.h"

#include <stdexcept>
#include <vector>

namespace cps {
namespace {

/// A narrow network that sees many images, with more regularisation than the small presets: it is for
/// pictures of other cameras than those that it was trained on.
TrainOptions reference_options() {
  TrainOptions o;
  o.architecture = "resnet18-32";
  o.reduction.width = 174;
  o.orientation.measured = true;
  o.epochs = 30;
  o.batch_size = 32;
  o.learning_rate = 2e-3;
  o.weight_decay = .05;
  o.dropout = .2;
  o.augmentation.probability = .2;
  o.ema_decay = .999;
  o.precision = Precision::automatic;
  o.minutes = 60;
  return o;
}

/// The seven models of the thesis. Each differs from the one before it only in what is set here.
/// docs/models.md says which values are the thesis' and which are our choice.
std::vector<TrainPreset> thesis_presets() {
  TrainOptions o;
  o.architecture = "resnet50";
  o.size_features = false;
  o.target_space = TargetSpace::raw;
  o.outputs = {"fov", "k1"};
  o.reduction = {.width = 0, .factor = 4};
  o.epochs = 50;
  o.warm_up_epochs = 0;
  o.milestones = {.3, .6, .9};
  o.max_gradient = 0;
  o.mirror = false;
  std::vector<TrainPreset> presets{{"cps-v0.1", "cps-v1 data: H-FOV and k1", o}};
  presets.push_back({"cps-v0.2", "cps-v2 data, H-FOV 30 to 150: H-FOV and k1", o});
  o.outputs = {"fov", "k1", "k2", "k3"};
  presets.push_back({"cps-v0.3", "cps-v2 data: the radial lens", o});
  o.outputs = {"fov", "k1", "k2", "k3", "p1", "p2"};
  presets.push_back({"cps-v0.4", "cps-v2 data: the whole lens", o});
  o.outputs = {output_names.begin(), output_names.end()};
  presets.push_back({"cps-v0.5", "cps-v2 data: all eight outputs", o});
  presets.push_back({"cps-v0.6", "cps-v3 data: two sizes", o});
  o.size_features = true;
  o.milestones = {.6, .85};
  presets.push_back({"cps-v0.7", "cps-v3 data: the size as a feature, multi-step schedule", o});
  return presets;
}

/// The method of Bogdan et al. 2018 on the network and schedule of `reference`, so that only the method
/// differs. It sees nothing but the picture.
TrainOptions deepcalib_options(Head head) {
  TrainOptions o = reference_options();
  o.head = head;
  o.reduction.width = 299;
  o.orientation.measured = false;
  o.size_features = false;
  return o;
}

}  // namespace

std::span<const TrainPreset> train_presets() {
  static const std::vector<TrainPreset> presets = [] {
    std::vector<TrainPreset> all{
        {"demo", "some two hundred images in three minutes of two cores", {.epochs = 30, .minutes = 3}},
        {"smoke", "some thousand images in eighteen minutes of two cores", {.epochs = 36, .minutes = 18}}};
    all.push_back({"reference", "some ten thousand images in an hour of two cores", reference_options()});
    all.push_back({"deepcalib-regression", "unified_spherical data: focal length and xi as two numbers",
                   deepcalib_options(Head::deepcalib_regression)});
    all.push_back({"deepcalib-classification", "unified_spherical data: focal length and xi as two bins",
                   deepcalib_options(Head::deepcalib_classification)});
    for (TrainPreset& preset : thesis_presets()) all.push_back(std::move(preset));
    return all;
  }();
  return presets;
}

const TrainOptions& train_preset(const std::string& name) {
  std::string known;
  for (const TrainPreset& preset : train_presets()) {
    if (preset.name == name) return preset.options;
    known += " " + preset.name;
  }
  throw std::runtime_error("preset '" + name + "': unknown: choose one of" + known);
}

}  // namespace cps
