#include <fmt/format.h>

#include <iostream>

#include "apps/dataset/job_flags.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "dataset/job/finish.h"
#include "production/make_views.h"
#include "production/remaining_views.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

Shard shard_from(const po::variables_map& values) {
  if (values.count("shard") == 0) return {};
  const auto& text = values["shard"].as<std::string>();
  try {
    return shard_from_string(text);
  } catch (const std::runtime_error& error) {
    throw po::error("--shard " + text + ": " + error.what());
  }
}

LightCacheOptions cache_from(const po::variables_map& values) {
  const LightCacheOptions cache{.memory_gib = values["cache_memory"].as<double>()};
  if (const std::string fault = cache.fault(); !fault.empty()) throw po::error("--" + fault);
  return cache;
}

/// Keeps a run's times for cps report. Without them the dataset is no less complete.
void enter(const fs::path& root, const Shard& shard, const RunTimes& times) try {
  enter_in_ledger(root, shard, times);
} catch (const std::exception& error) {
  std::cout << error.what() << ": cps report will not know of this run's time\n";
}

/// Makes the remaining views of a shard. Throws Interrupted when a signal came before all were made.
void make_remaining(const Plan& plan, const RemainingViews& remaining, const Shard& shard, Journal& journal,
                    const fs::path& root, int threads, const LightCacheOptions& cache, Watch watch) {
  write_labels(plan, remaining.views, root);
  Progress progress("images", remaining.made_images, remaining.shard_images);
  watch.advance = [&](std::int64_t images, const std::string& view) { progress.advance(images, view); };
  const MakeViewsSummary summary = make_views(plan, remaining.views, journal, root, threads, watch, cache);
  progress.finish();
  std::cout << summary.brief() << "\n";
  for (const std::string& warning : summary.badly_exposed.warnings()) watch.warned(warning);
  enter(root, shard, summary);
  if (summary.is_interrupted) throw Interrupted();
}

/// One line about the plan and, where places were drawn, about those.
std::string brief(const Plan& plan) {
  std::string line =
      fmt::format("{} views, {} groups, {} images", plan.views.size(), plan.groups.size(), image_count(plan));
  return plan.places.drawn > 0 ? line + "; " + plan.places.brief() : line;
}

int generate(const po::variables_map& values, int threads) {
  const fs::path root = values["out"].as<std::string>();
  const std::string name = root.string();
  const Shard shard = shard_from(values);
  const bool is_whole = shard.count == 1;
  const LightCacheOptions cache = cache_from(values);
  Watch watch = interruptible_watch();
  look_with_flags(values, watch);

  DatasetJob job = job_from_flags(values, root);
  require_same_job(root, job.text);
  if (is_finished(root)) {
    std::cout << name << ": is finished; nothing to do\n";
    return 0;
  }
  require_scenes(job);
  Plan plan = outline_of(job);

  FileLock folder(folder_lock(root), FileLock::Kind::shared);
  if (!folder.is_held()) throw HeldByAnother(name + ": is just being finished by another process");
  Journal journal(root, shard);
  const RemainingViews remaining = remaining_views(plan, shard, root, watch);
  // A dataset is finished with the places of all its views; a shard needs those that it renders.
  prepare_views(job, plan, is_whole ? all_views(plan) : remaining.views, root, watch);
  begin_job(root, job.text);
  std::cout << name << ": " << brief(plan) << "\n";
  const std::string share = is_whole ? "" : "shard " + to_string(shard) + ": ";
  std::cout << share << remaining.views.size() << " views to make" << std::endl;
  if (!remaining.views.empty()) make_remaining(plan, remaining, shard, journal, root, threads, cache, watch);

  if (!is_whole) {
    std::cout << share << "made; when all are: cps finish " << name << "\n";
    return 0;
  }
  if (!folder.make_exclusive()) {
    std::cout << name << ": all is made, but other processes still work there; then: cps finish " << name
              << "\n";
    return exit_run_again;
  }
  finish_dataset(root, plan, read_journals(root).views, job.scene_sha256);
  std::cout << name << ": finished\n";
  return 0;
}

}  // namespace

const Manual generate_manual{
    .name = "cps generate",
    .summary = "make a dataset from a recipe, or resume one",
    .synopsis = {"--recipe FILE --out FOLDER [--shard I/N] [--KEY VALUE ...]"},
    .description = R"(
Plans every view and lens of a dataset, renders each view once, and photographs
it through its lenses.

Run the same command again after an interruption to continue; a finished dataset
is left alone. With --shard it makes one of N shares of the images; when all N
are made, cps finish completes the dataset. The result is the same, byte for
byte, for any number of threads, shares and interruptions.

Every key of a recipe is also an option, which overrides the file; --scene,
--city_seed and --cities together replace all scenes of the file.

SIGTERM and SIGINT end the program after it has written the images of the views
already rendered; a second one kills it.
)",
    .exit_status = {{"0", "done"},
                    {"1", "failed"},
                    {"2", "wrong usage"},
                    {"75",
                     "interrupted by SIGTERM or SIGINT, or another process makes the same images: run it "
                     "again"}},
    .examples = {{"cps generate --recipe demo --out data",
                  "makes the dataset of the shipped recipe demo, with a city of its own"},
                 {"cps generate --recipe demo --scene city.glb --views 10 --out data",
                  "makes ten views per size and H-FOV of a scene of yours"},
                 {"cps generate --recipe fisheye --out fisheyes",
                  "makes fisheye images, which are no CPS dataset: labels of another lens family"},
                 {"cps generate --recipe cps-v2 --out /share/data --shard 3/8 --threads 16",
                  "makes the fourth of eight shares with 16 threads"}},
    .see_also = {"cps plan", "cps finish", "cps verify", "cps contact-sheet", "cps-slurm"},
};

int cps_generate(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("out,o", po::value<std::string>()->value_name("FOLDER")->required(),
                        "the dataset's folder")("shard", po::value<std::string>()->value_name("I/N"),
                                                "make only share I of N, as 0/4 … 3/4")(
      "cache_memory", po::value<double>()->value_name("GIB")->default_value(LightCacheOptions{}.memory_gib),
      "GiB for the cells of light_method = cached; what does not fit is computed again");
  po::variables_map values;
  if (!parse_job_options(arguments, generate_manual, options, values)) return 0;

  const ThreadLimit threads(values);
  return run_interruptible(values["out"].as<std::string>(), [&] { return generate(values, threads.count); });
}

}  // namespace cps
