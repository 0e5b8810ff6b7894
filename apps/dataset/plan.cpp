#include <fmt/format.h>
#include <tbb/info.h>

#include <iostream>

#include "apps/dataset/job_flags.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "production/costs/bill.h"
#include "sampler/plan/shard.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

/// Free space on the disk where the folder is or would be made.
double free_bytes(fs::path folder) {
  folder = fs::absolute(folder);
  while (!fs::exists(folder) && folder.has_parent_path() && folder != folder.parent_path())
    folder = folder.parent_path();
  return static_cast<double>(fs::space(folder).available);
}

/// stdout is the estimate's alone, for programs.
void print_on_stderr(const std::string& line) {
  std::cerr << line << "\n";
}

}  // namespace

const Manual plan_manual{
    .name = "cps plan",
    .summary = "estimate what a recipe makes and costs",
    .synopsis =
        {"--recipe FILE [--cores N] [--shards N] [--price P] [--out FOLDER] [--json] [--KEY VALUE ...]"},
    .description = R"(
Estimates what a dataset takes before it is begun: images, core-hours, memory,
disk, time and money. Renders a few views of the recipe in a temporary folder
(TMPDIR) and extrapolates. Core-hours are CPU time on a machine like this one.

Every key of a recipe is also an option, which overrides the file.
)",
    .examples = {{"cps plan --recipe cps-v2 --cores 1000 --price 0.04 --out /share",
                  "estimates time and price on a thousand cores, and whether /share has room"},
                 {"cps plan --recipe cps-v2 --shards 400",
                  "counts what four hundred processes spend before they render"}},
    .see_also = {"cps generate"},
};

int cps_plan(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("out,o", po::value<std::string>()->value_name("FOLDER")->default_value("."),
                        "the dataset's folder, to compare with the free space there")(
      "cores", po::value<int>()->default_value(tbb::info::default_concurrency(), "this machine's"),
      "cores that will share the work, to estimate the time")(
      "shards", po::value<std::int64_t>()->default_value(1),
      "processes that will share the work, as cps generate --shard I/N; each must start")(
      "price", po::value<double>()->default_value(0), "price of a core-hour")(
      "conditions", po::value<int>()->default_value(5),
      "conditions to measure, with one view of each size and H-FOV in each")("json", "print JSON");
  po::variables_map values;
  if (!parse_job_options(arguments, plan_manual, options, values)) return 0;
  const int conditions = values["conditions"].as<int>();
  const auto shards = values["shards"].as<std::int64_t>();
  Resources resources{.cores = values["cores"].as<int>(),
                      .price_per_core_h = values["price"].as<double>(),
                      .folder = values["out"].as<std::string>()};
  if (resources.cores < 1 || resources.cores > 10'000'000)
    throw po::error("--cores: must lie in [1, 10000000]");
  if (!(resources.price_per_core_h >= 0 && resources.price_per_core_h <= 1e6))
    throw po::error("--price: must lie in [0, 1000000]");
  if (shards < 1 || shards > max_shards)
    throw po::error(fmt::format("--shards: must lie in [1, {}]", max_shards));
  if (conditions < 1 || conditions > 1000) throw po::error("--conditions: must lie in [1, 1000]");

  const ThreadLimit threads(values);
  const DatasetJob job = job_from_flags(values, resources.folder);
  resources.free_bytes = free_bytes(resources.folder);
  const RecipeCounts counts = count_out(job.recipe, static_cast<int>(job.rig.cameras.size()));
  Watch watch{.note = print_on_stderr, .warn = print_on_stderr};
  look_with_flags(values, watch);
  const Pilot pilot = run_pilot(job.recipe, job.rig, job.drive, conditions, watch);
  const Bill bill = bill_of(job.recipe, counts, pilot, {.shards = shards, .threads = threads.count});
  if (values.count("json") > 0)
    std::cout << to_json(job.recipe, bill, pilot, resources).dump(1) << "\n";
  else
    std::cout << to_text(job.recipe, bill, pilot, resources);
  return 0;
}

}  // namespace cps
