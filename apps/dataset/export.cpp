#include "dataset/export/export.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/interruption.h"
#include "apps/options.h"
#include "apps/progress.h"
#include "apps/verbs.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct ExportRequest {
  fs::path dataset, output;
  std::string target;
  ExportOptions options;
};

po::options_description describe(ExportRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("dataset", path_value(r.dataset)->value_name("DATASET")->required(),
      "the dataset's folder; its name alone will do, without --dataset");
  add("to", po::value(&r.target)->value_name("TARGET")->required(),
      "webdataset, huggingface, colmap, nerfstudio, kitti or coco");
  add("out,o", path_value(r.output)->value_name("FOLDER")->required(),
      "folder to write: new or empty, or that of the same export");
  add("shard_mb", po::value(&r.options.shard_mb)->default_value(r.options.shard_mb),
      "webdataset: most millions of bytes in a tar");
  add("copy", po::bool_switch(&r.options.copy), "copy images instead of linking them");
  add("license", po::value(&r.options.license), "huggingface: identifier of the licence, such as cc-by-4.0");
  add("url", po::value(&r.options.url), "huggingface: page of the dataset, for croissant.json");
  add("creator", po::value(&r.options.creator), "huggingface: who made the dataset, for croissant.json");
  add("published", po::value(&r.options.published), "huggingface: YYYY-MM-DD, for croissant.json");
  return options;
}

ExportTarget target_of(const std::string& name) try {
  return export_target_from_string(name);
} catch (const std::runtime_error& error) {
  throw po::error("--to " + name + ": " + error.what());
}

int run_export(const ExportRequest& request) {
  const Watch watch = interruptible_watch();
  const ExportSource source = read_export_source(request.dataset);
  const std::size_t images = source.dataset().images.size();
  Progress progress("images", 0, static_cast<std::int64_t>(images));
  const ExportSummary summary = export_dataset(source, request.output, request.options,
                                               [&](std::int64_t more, const std::string& current) {
                                                 progress.advance(more, current);
                                                 if (watch.is_stopped()) throw Interrupted();
                                               });
  const std::string name = request.output.string();
  if (summary.was_finished) {
    std::cout << name << ": is finished; nothing to do\n";
  } else {
    progress.finish();
    std::cout << fmt::format("{}: {} images for {}\n", name, images, request.target);
  }
  if (!summary.note.empty()) std::cout << name << ": " << summary.note << "\n";
  return 0;
}

}  // namespace

const Manual export_manual{
    .name = "cps export",
    .summary = "write a dataset in the layout that another program reads",
    .synopsis = {"DATASET --to TARGET -o FOLDER"},
    .description = R"(
Writes a finished dataset for another program. The targets are webdataset (tars
of images with their labels as JSON, for each split), huggingface (a folder per
split with metadata.jsonl, a dataset card and croissant.json), colmap (a text
model with images for each condition), nerfstudio (transforms.json with images
for each condition), kitti (KITTI raw's folders, a calibration and its drives
for each group) and coco (COCO's detection format: boxes and masks of objects).

Dense labels go along to webdataset and huggingface. coco is made of two of
them, instance and semantic; the dataset's recipe asks for them with the key
labels.

Images are not encoded anew. Outside of tars they are hard links to those of the
dataset where the file system allows it: then a change to one changes the other.
Run the same command again after an interruption, and it goes on.
)",
    .exit_status =
        {{"0", "done"},
         {"1", "failed"},
         {"2", "wrong usage"},
         {"75",
          "interrupted by SIGTERM or SIGINT, or another process exports to the same folder: run it "
          "again"}},
    .examples = {{"cps export data --to webdataset -o tars", "makes tars for training"},
                 {"cps export data --to huggingface --license cc-by-4.0 -o hub",
                  "makes a folder to share on Hugging Face"},
                 {"cps export data --to coco -o coco", "makes a folder to train a detector on"}},
    .see_also = {"cps generate", "cps report"},
};

int cps_export(const Arguments& arguments) {
  ExportRequest request;
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments, export_manual, describe(request), positional, values)) return 0;
  po::notify(values);
  request.options.target = target_of(request.target);
  refuse_flags_with(request.options.fault());
  if (!values["shard_mb"].defaulted() && request.options.target != ExportTarget::webdataset)
    throw po::error("--shard_mb: is for --to webdataset only: leave it out");
  return run_interruptible(request.output.string(), [&] { return run_export(request); });
}

}  // namespace cps
