#include "trainer/training/train.h"

#include <filesystem>
#include <iostream>
#include <sstream>

#include "apps/options.h"
#include "apps/train/summaries.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "trainer/model/model_card.h"
#include "trainer/model/train_presets.h"
#include "trainer/network/architectures.h"
#include "trainer/onnx/export_onnx.h"
#include "trainer/training/ranks.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

/// Declares a flag that sets `value` if it is given; the help shows the default.
template <typename T>
void flag(po::options_description& options, const char* name, T& value, const std::string& text) {
  std::ostringstream shown;
  shown << text << " [" << value << "]";
  options.add_options()(name, po::value<T>(&value), shown.str().c_str());
}

/// Flags whose values are words, before they are parsed.
struct Words {
  std::string target_space, loss, precision, head;
};

Words words_of(const TrainOptions& o) {
  return {to_string(o.target_space), to_string(o.loss), to_string(o.precision),
          is_fit(o.head) ? "fit" : "direct"};
}

/// Sets the head, and what a fit needs, which later flags may still change.
void choose_head(TrainOptions& options, const std::string& word) {
  if (is_deepcalib(options.head)) throw po::error("--head: the preset has a deepcalib head: leave it out");
  if (word != "direct" && word != "fit") throw po::error("--head: must be direct or fit");
  options.head = word == "fit" ? Head::brown_conrady_fit : Head::brown_conrady;
  if (word == "direct") return;
  options.orientation.measured = true;
  options.target_space = TargetSpace::seen;
}

po::options_description training_flags(TrainOptions& o, Words& words) {
  po::options_description options("How to train (defaults without --preset in brackets)");
  std::string names;
  for (const Architecture& architecture : architectures())
    names += (names.empty() ? "" : ", ") + architecture.name;
  flag(options, "arch", o.architecture, "architecture: " + names);
  options.add_options()(
      "init", po::value(&o.initial_weights)->value_name("FILE"),
      "start from the weights in this file: a .pth of torchvision's ResNets, or the weights.pt of a model");
  flag(options, "size-features", o.size_features, "give the network the size of the original image");
  flag(options, "sobel", o.edge_channel, "give the network each image's Sobel edges as a second channel");
  flag(options, "orientation", o.orientation.measured,
       "give the network the orientation of edges, measured at the image's own size");
  flag(options, "orientation-width", o.orientation.max_width,
       "with --orientation: wider images are reduced to this width before it is measured, pixels");
  flag(options, "head", words.head,
       "direct: the network's outputs as they are; fit: joined with a fit to the picture's edges, which "
       "the network weighs; they have standard deviations then (sets --orientation and --targets seen)");
  flag(options, "loss", words.loss,
       "mse or huber of the standardised outputs, or reprojection (pixel distance)");
  flag(options, "targets", words.target_space,
       "space of the outputs: apparent (coefficients scaled by the half diagonal), seen (the same with the "
       "H-FOV that the image sees), or raw");
  flag(options, "width", o.reduction.width,
       "width of the network's images, pixels; images are never enlarged");
  flag(options, "reduce", o.reduction.factor,
       "instead of --width: divide both sides by this; 0: use --width");
  flag(options, "epochs", o.epochs, "passes over the training images");
  flag(options, "batch", o.batch_size, "images per batch; all have one size");
  flag(options, "batches-per-step", o.batches_per_step,
       "batches whose mean gradient makes a step; a multiple of the number of processes");
  flag(options, "lr", o.learning_rate, "learning rate of AdamW");
  flag(options, "weight-decay", o.weight_decay, "weight decay of AdamW");
  flag(options, "warm-up", o.warm_up_epochs, "epochs over which the learning rate rises from 0");
  flag(options, "decay", o.decay, "factor on the learning rate at each milestone");
  flag(options, "dropout", o.dropout, "dropout probability of the features before the last layer");
  flag(options, "max-gradient", o.max_gradient, "scale larger gradient norms down to this; 0: never");
  flag(options, "skip-bad-images", o.skip_bad_images,
       "leave out images that cannot be used, and name them, instead of stopping");
  flag(options, "places-share", o.places_share,
       "train on the images of this share of the training places; a smaller share is a part of a larger one");
  flag(options, "mirror", o.mirror, "flip a random half of the images in each epoch, with exact labels");
  flag(
      options, "augment", o.augmentation.probability,
      "probability of each random change that keeps the label exact: blur, motion blur, gamma, noise, JPEG, contrast, cutout");
  flag(options, "online-lenses", o.online_lenses,
       "train on the masters kept in the dataset, each with a new lens in every epoch");
  flag(options, "online-zoom", o.online_zoom,
       "online lenses: largest factor between a drawn focal length and that of the master's set");
  options.add_options()("teacher", po::value(&o.teacher)->value_name("MODEL"),
                        "model folder of a trained network to learn from, too (distillation)");
  flag(options, "teacher-weight", o.teacher_weight,
       "weight of the teacher in the loss; the labels have the rest");
  flag(options, "ema", o.ema_decay,
       "decay of a running mean of the weights, which is then validated and saved; 0: none");
  flag(options, "patience", o.patience,
       "stop after so many epochs without a better validation loss; 0: never");
  flag(options, "seed", o.seed, "seed of all random choices");
  flag(options, "threads", o.threads, "number of threads; 0 means one per core");
  flag(options, "precision", words.precision,
       "of the convolutions: float32, bfloat16, or auto: bfloat16 if the processor computes it");
  flag(options, "minutes", o.minutes,
       "time budget: fewer epochs and a shorter schedule if needed to stay within it; 0: none");
  options.add_options()("milestones",
                        po::value<std::vector<double>>(&o.milestones)->value_name("NUMBERS")->multitoken(),
                        "fractions of the epochs at which the learning rate decays [0.6 0.85]")(
      "outputs", po::value<std::vector<std::string>>(&o.outputs)->value_name("NAMES")->multitoken(),
      "outputs to learn, from fov k1 k2 k3 p1 p2 cx cy [all]");
  return options;
}

}  // namespace

const Manual train_manual{
    .name = "cps train",
    .summary = train_line.text,
    .synopsis = {"--data DATASET --out MODEL [--preset NAME] [--KEY VALUE ...]",
                 "--data DATASET --out MODEL --resume"},
    .description = R"(
Trains a network on the train images of a dataset and keeps the weights that do
best on its val images. After an interruption, --resume continues. The presets
whose names begin with deepcalib learn the lenses of unified_spherical datasets,
the others those of brown_conrady datasets; another dataset is refused.

cps train, cps eval and cps predict run the program cps-train, which is
installed beside cps and is the only one that needs LibTorch; cps-train train
does the same as cps train. Several processes, started by srun, train together.
)",
    .examples = {{"cps train --data data --out model --preset demo", "trains for three minutes"},
                 {"cps train --data data --out model --resume", "continues the training of model"}},
    .see_also = {"cps eval", "cps predict", "cps generate"},
};

int train_verb(const Arguments& arguments) {
  TrainOptions options;
  Words words = words_of(options);
  std::string data, out, device, presets;
  bool with_onnx = true;
  for (const TrainPreset& preset : train_presets()) presets += preset.name + ": " + preset.purpose + "; ";

  po::options_description files("Options");
  files.add_options()("data", po::value<std::string>(&data)->value_name("DATASET")->required(),
                      "dataset folder")("out,o",
                                        po::value<std::string>(&out)->value_name("MODEL")->required(),
                                        "model folder, created if missing")(
      "preset", po::value<std::string>()->value_name("NAME"), (presets + "flags below override it").c_str())(
      "device", po::value<std::string>(&device)->value_name("DEVICE")->default_value("cpu"),
      "where to compute: cpu or cuda")("resume", po::bool_switch(),
                                       "continue the training of the model in --out, with its own options");
  flag(files, "onnx", with_onnx,
       "at the end, also write the network as model.onnx (not with --head fit, --targets seen or a "
       "deepcalib preset)");
  const po::options_description how = training_flags(options, words);
  po::options_description all = files;
  all.add(how);
  po::variables_map values;
  if (!parse_options(arguments, train_manual, all, {}, values)) return 0;

  const bool resume = values["resume"].as<bool>();
  if (resume)
    for (const auto& [name, value] : values)
      if (name == "preset" || how.find_nothrow(name, false))
        throw po::error("--" + name + " cannot be combined with --resume, which keeps the model's options");
  if (values.count("preset"))
    options = usage_checked([&] { return train_preset(values["preset"].as<std::string>()); });
  if (values.count("head")) choose_head(options, values["head"].as<std::string>());
  words = words_of(options);
  po::notify(values);
  options.target_space = usage_checked([&] { return target_space_from_string(words.target_space); });
  const Device computed_on = usage_checked([&] { return device_from_string(device); });
  options.loss = usage_checked([&] { return loss_from_string(words.loss); });
  options.precision = usage_checked([&] { return precision_from_string(words.precision); });
  if (const std::string fault = options.fault(); !fault.empty()) throw po::error(fault);

  const Ranks ranks = join_ranks();
  if (!values.count("batches-per-step")) options.batches_per_step = ranks.count;
  const Dataset dataset = read_dataset(data, LensFamilies::any);
  const TrainSummary summary = train(
      dataset, out, options, resume,
      [&](const EpochReport& report) {
        if (ranks.rank == 0) std::cout << to_string(report) << std::endl;
        return true;
      },
      ranks, computed_on);
  if (ranks.rank != 0) return 0;
  for (const std::string& why : summary.skipped) std::cerr << "left out: " << why << "\n";
  if (with_onnx && onnx_fault(load_model_card(out).options).empty())
    write_onnx(out, fs::path(out) / onnx_file_name);
  std::cout << summary.brief_report() << "\nmodel in " << out << "\n";
  return 0;
}

}  // namespace cps
