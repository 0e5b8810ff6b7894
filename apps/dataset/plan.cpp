#include <tbb/info.h>

#include <iostream>

#include "apps/dataset/recipe_file.h"
#include "apps/options.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "production/costs/bill.h"
#include "production/dataset_job.h"
#include "production/drive_options.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

constexpr const char* usage =
    "cps plan --recipe FILE [--cores N] [--price P] [--out DIR] [--json] [--KEY VALUE …]\n"
    "What a dataset will take before it is begun: images, core-hours, memory, disk, time, money. A few views "
    "are really rendered, in a temporary folder.\n";

/// Free space where the folder is, or will be.
double free_bytes(fs::path folder) {
  folder = fs::absolute(folder);
  while (!fs::exists(folder) && folder.has_parent_path() && folder != folder.parent_path())
    folder = folder.parent_path();
  return static_cast<double>(fs::space(folder).available);
}

}  // namespace

int cps_plan(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("recipe", po::value<std::string>(),
                        "recipe file, or the name of one that is installed, as cps-v2")(
      "out,o", po::value<std::string>()->default_value("."), "where the dataset would go: for its free space")(
      "cores", po::value<int>()->default_value(tbb::info::default_concurrency()), "for the time it takes")(
      "price", po::value<double>()->default_value(0), "of a core-hour")(
      "conditions", po::value<int>()->default_value(5), "so many are measured, a view of every set in each")(
      "json", "machine-readable");
  add_threads_option(options);
  options.add(drive_flags()).add(recipe_options());
  po::variables_map values;
  if (!parse_options(arguments, usage, options, {}, values)) return 0;
  store_named_recipe(values);
  po::notify(values);
  const int conditions = values["conditions"].as<int>();
  Resources resources{.cores = values["cores"].as<int>(),
                      .price_per_core_h = values["price"].as<double>(),
                      .folder = values["out"].as<std::string>()};
  if (resources.cores < 1 || resources.cores > 10'000'000)
    throw po::error("--cores: must lie in [1, 10000000]");
  if (!(resources.price_per_core_h >= 0 && resources.price_per_core_h <= 1e6))
    throw po::error("--price: must lie in [0, 1000000]");
  if (conditions < 1 || conditions > 1000) throw po::error("--conditions: must lie in [1, 1000]");

  const ThreadLimit threads(values);
  const DatasetJob job = job_from_flags(values, resources.folder);
  resources.free_bytes = free_bytes(resources.folder);
  const RecipeCounts counts = count_out(job.recipe, static_cast<int>(job.rig.cameras.size()));
  const Pilot pilot = run_pilot(job.recipe, job.rig, job.drive, conditions);
  const Bill bill = bill_of(job.recipe, counts, pilot, threads.count);
  if (values.count("json") > 0)
    std::cout << to_json(job.recipe, bill, pilot, resources).dump(1) << "\n";
  else
    std::cout << to_text(job.recipe, bill, pilot, resources);
  return 0;
}

}  // namespace cps
