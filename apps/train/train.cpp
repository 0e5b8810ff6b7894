#include "trainer/training/train.h"

#include <iostream>
#include <sstream>

#include "apps/options.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "trainer/model/train_presets.h"
#include "trainer/training/ranks.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// Declares a flag that writes to `value` when it is given, and says in the help what holds when it is not.
template <typename T>
void flag(po::options_description& options, const char* name, T& value, const std::string& text) {
  std::ostringstream shown;
  shown << text << " [" << value << "]";
  options.add_options()(name, po::value<T>(&value), shown.str().c_str());
}

/// What flags say in words, before it is understood.
struct Words {
  std::string target_space, loss;
};

po::options_description training_flags(TrainOptions& o, Words& words) {
  po::options_description options("How to train (in brackets: without --preset)");
  flag(options, "arch", o.architecture, "resnet18, -34, -50, -101 or resnet34-nopool");
  options.add_options()(
      "init", po::value(&o.initial_weights),
      "start from the weights in this file: a .pth of torchvision's ResNets, or a model's weights.pt");
  flag(options, "size-features", o.size_features, "tell the network the original image's size");
  flag(options, "sobel", o.edge_channel, "show the network each image's Sobel edges beside it");
  flag(options, "loss", words.loss, "mse or huber, of standardised outputs; reprojection, in pixels");
  flag(options, "targets", words.target_space, "apparent (coefficients scaled by the half diagonal) or raw");
  flag(options, "width", o.reduction.width, "network image's width, pixels; never enlarged");
  flag(options, "reduce", o.reduction.factor, "instead: divide both sides by this; 0: by width");
  flag(options, "epochs", o.epochs, "passes over the training images");
  flag(options, "batch", o.batch_size, "images per step, of one size");
  flag(options, "batches-per-step", o.batches_per_step,
       "whose mean gradient makes a step; a multiple of the number of processes");
  flag(options, "lr", o.learning_rate, "learning rate of AdamW");
  flag(options, "weight-decay", o.weight_decay, "of AdamW");
  flag(options, "warm-up", o.warm_up_epochs, "epochs over which the rate rises from 0");
  flag(options, "decay", o.decay, "the rate's factor at each milestone");
  flag(options, "dropout", o.dropout, "of the features before the last layer");
  flag(options, "max-gradient", o.max_gradient, "longer gradients are scaled down to it; 0: never");
  flag(options, "skip-bad-images", o.skip_bad_images, "leave out images that cannot be used, and name them");
  flag(options, "mirror", o.mirror, "show every second image flipped, with its exact label");
  flag(options, "augment", o.augmentation.probability,
       "chance of each change that leaves the label true: blur, motion blur, gamma, noise, JPEG, contrast, "
       "cutout");
  flag(options, "online-lenses", o.online_lenses,
       "learn from the masters that the dataset keeps, through a new lens for each in every epoch");
  flag(options, "online-zoom", o.online_zoom,
       "of online lenses: the most by which a drawn focal length differs from that of the master's set");
  options.add_options()("teacher", po::value(&o.teacher),
                        "learn from what this trained model says as well (distillation)");
  flag(options, "teacher-weight", o.teacher_weight, "its share in the loss; the labels have the rest");
  flag(options, "ema", o.ema_decay, "decay of a running mean of the weights, which is then kept; 0: none");
  flag(options, "patience", o.patience, "stop after so many epochs without a better val loss; 0: never");
  flag(options, "seed", o.seed, "of weights, order and flips");
  flag(options, "threads", o.threads, "0: all cores");
  flag(options, "minutes", o.minutes, "wall budget: epochs are cut to fit, the schedule with them; 0: none");
  options.add_options()("milestones", po::value<std::vector<double>>(&o.milestones)->multitoken(),
                        "fractions of the epochs at which the rate decays [0.6 0.85]")(
      "outputs", po::value<std::vector<std::string>>(&o.outputs)->multitoken(),
      "those of fov k1 k2 k3 p1 p2 cx cy that are learned [all]");
  return options;
}

}  // namespace

int train_verb(const Arguments& arguments) {
  TrainOptions options;
  Words words{to_string(options.target_space), to_string(options.loss)};
  std::string data, out, device, presets;
  for (const TrainPreset& preset : train_presets()) presets += preset.name + ": " + preset.purpose + "; ";

  po::options_description files("What to train");
  files.add_options()("data", po::value<std::string>(&data)->required(), "the dataset's folder")(
      "out,o", po::value<std::string>(&out)->required(), "the model's folder, made if need be")(
      "preset", po::value<std::string>(), (presets + "the flags below override it").c_str())(
      "device", po::value<std::string>(&device)->default_value("cpu"), "cpu or cuda")(
      "resume", po::bool_switch(), "go on with the model in --out where it stopped, with its own options");
  const po::options_description how = training_flags(options, words);
  po::options_description all;
  all.add(files).add(how);
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps train --data DATASET --out MODEL\nTrains a network on the train images of a dataset and keeps "
          "the weights that do best on its val images.\n",
          all, {}, values))
    return 0;

  const bool resume = values["resume"].as<bool>();
  if (resume)
    for (const auto& [name, value] : values)
      if (name == "preset" || how.find_nothrow(name, false))
        throw po::error("--" + name + " cannot be changed by --resume, which goes on as the model began");
  if (values.count("preset"))
    options = usage_checked([&] { return train_preset(values["preset"].as<std::string>()); });
  words = {to_string(options.target_space), to_string(options.loss)};
  po::notify(values);
  options.target_space = usage_checked([&] { return target_space_from_string(words.target_space); });
  const Device computed_on = usage_checked([&] { return device_from_string(device); });
  options.loss = usage_checked([&] { return loss_from_string(words.loss); });
  std::string why;
  if (!options.is_valid(&why)) throw po::error(why);

  const Ranks ranks = join_ranks();
  if (!values.count("batches-per-step")) options.batches_per_step = ranks.count;
  const Dataset dataset = read_dataset(data);
  const TrainSummary summary = train(
      dataset, out, options, resume,
      [&](const EpochReport& report) {
        if (ranks.rank == 0) std::cout << to_string(report) << std::endl;
        return true;
      },
      ranks, computed_on);
  if (ranks.rank != 0) return 0;
  for (const std::string& why : summary.skipped) std::cerr << "left out: " << why << "\n";
  std::cout << summary.brief_report() << "\nmodel in " << out << "\n";
  return 0;
}

}  // namespace cps
