
#include <iostream>
#include <set>

#include "apps/dataset/recipe_file.h"
#include "apps/options.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "dataset/job/finish.h"
#include "dataset/job/gaps.h"
#include "dataset/labels/group_label.h"
#include "production/dataset_job.h"
#include "production/drive_options.h"
#include "production/interruption.h"
#include "production/make_views.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

constexpr const char* usage =
    "cps generate --recipe FILE --out DIR [--shard I/N] [--KEY VALUE …]\n"
    "Makes a dataset: plans every view and lens, renders each view once, and sends it through its lenses and "
    "the sensor.\n"
    "Run it again after an interruption and it finishes the job; a finished job is left alone. With --shard "
    "it "
    "makes one of N shares of the images, and cps finish makes a dataset of them when all are there.\n"
    "Exit status: 0 done, 1 failed, 2 wrong usage, 75 interrupted by SIGTERM or SIGINT, or another "
    "process makes the same: run it again.\n";

Shard shard_from(const po::variables_map& values) {
  if (values.count("shard") == 0) return {};
  const auto& text = values["shard"].as<std::string>();
  try {
    return shard_from_string(text);
  } catch (const std::runtime_error& error) {
    throw po::error("--shard " + text + ": " + error.what());
  }
}

/// What of the shard is still to be made, and how many of its images are there.
struct Remainder {
  std::vector<std::int64_t> views;
  std::int64_t images = 0, made_images = 0;
};

Remainder remainder_of(const Plan& plan, const Shard& shard, const fs::path& root) {
  const JournalLines known = read_journals(root);
  if (known.unreadable > 0)
    std::cout << root.string() << ": " << known.unreadable
              << " damaged lines in the journals; their views are made again\n";
  Remainder remainder;
  const ViewRange range = views_of(plan, shard);
  for (std::int64_t v = range.begin; v < range.end; ++v) {
    const auto images = static_cast<std::int64_t>(plan.views[v].groups.size());
    remainder.images += images;
    if (is_made(root, plan, v, known.views))
      remainder.made_images += images;
    else
      remainder.views.push_back(v);
  }
  return remainder;
}

void write_labels(const Plan& plan, const std::vector<std::int64_t>& views, const fs::path& root) {
  std::set<int> groups;
  for (std::int64_t v : views) groups.insert(plan.views[v].groups.begin(), plan.views[v].groups.end());
  for (int g : groups) write_label(root, plan, plan.groups[g]);
}

/// Makes what is missing of the shard. False when a signal came before it was whole.
bool make_shard(const Plan& plan, const Shard& shard, Journal& journal, const fs::path& root, int threads) {
  const Remainder remainder = remainder_of(plan, shard, root);
  std::cout << remainder.views.size() << " views to make" << std::endl;
  if (remainder.views.empty()) return true;
  write_labels(plan, remainder.views, root);
  Progress progress("images", remainder.made_images, remainder.images);
  const MakeViewsSummary summary = make_views(plan, remainder.views, journal, root, threads, progress);
  progress.finish();
  std::cout << summary.brief() << "\n";
  return !summary.is_interrupted;
}

int generate(const po::variables_map& values, int threads) {
  const fs::path root = values["out"].as<std::string>();
  const std::string name = root.string();
  const Shard shard = shard_from(values);
  DatasetJob job = job_from_flags(values, root);
  require_same_job(root, job.text);
  if (is_finished(root)) {
    std::cout << name << ": is finished; nothing to do\n";
    return 0;
  }
  prepare_scenes(job, root);
  const Plan plan = plan_of(job);

  FileLock folder(folder_lock(root), FileLock::Kind::shared);
  if (!folder.is_held()) throw HeldByAnother(name + ": is just being finished by another process");
  begin_job(root, job.text);
  Journal journal(root, shard);
  std::cout << name << ": " << plan.views.size() << " views, " << plan.groups.size() << " groups, "
            << image_count(plan) << " images; " << plan.places.brief() << "\n";
  if (shard.count > 1) std::cout << "shard " << to_string(shard) << ": ";
  if (!make_shard(plan, shard, journal, root, threads)) throw Interrupted();
  if (shard.count > 1) {
    std::cout << "shard " << to_string(shard) << ": made; when all are: cps finish " << name << "\n";
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

int cps_generate(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("recipe", po::value<std::string>(),
                        "recipe file, or the name of one that is installed, as cps-v2")(
      "out,o", po::value<std::string>()->required(), "the dataset's folder")(
      "shard", po::value<std::string>(), "make only share I of N, as 0/4 … 3/4");
  add_threads_option(options);
  options.add(drive_flags()).add(recipe_options());
  po::variables_map values;
  if (!parse_options(arguments, usage, options, {}, values)) return 0;
  store_named_recipe(values);
  po::notify(values);

  const ThreadLimit threads(values);
  return run_interruptible(values["out"].as<std::string>(), [&] { return generate(values, threads.count); });
}

}  // namespace cps
