#include "dataset/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/interruption.h"
#include "apps/options.h"
#include "apps/progress.h"
#include "apps/verbs.h"
#include "dataset/verify/verify_plan.h"
#include "production/dataset_job.h"
#include "production/rerender.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

/// One line about all images rendered again.
std::string brief(const std::vector<RerenderedImage>& images) {
  double shift = 0, blocks = 0, min_db = 1e30;
  for (const RerenderedImage& image : images) {
    const Registration& found = image.registration;
    shift = std::max(shift, std::hypot(found.shift_x_px, found.shift_y_px));
    blocks = std::max(blocks, found.block_rms_px);
    min_db = std::min(min_db, found.psnr_db);
  }
  return fmt::format(
      "{} images rendered again: shifts up to {:.3f} px, blocks up to {:.3f} px rms, at least {:.1f} dB",
      images.size(), shift, blocks, min_db);
}

struct MadeAgain {
  bool is_planned = false;
  std::vector<std::string> faults = {};
};

/// Plans the dataset and renders images again, if job and scenes are there.
MadeAgain make_again(const fs::path& root, const RerenderOptions& options) {
  const auto skip = [&](const std::string& why) -> MadeAgain {
    if (options.images > 0) throw std::runtime_error(root.string() + ": " + why + ", which --rerender needs");
    std::cout << root.string() << ": " << why << ": not planned again\n";
    return {};
  };
  if (!has_job(root)) return skip("has no .cps/job.json");
  DatasetJob job = job_of_folder(root);
  if (!has_scenes(job)) return skip("its scenes are not there");
  prepare_scenes(job, root);
  const Plan plan = plan_of(job, interruptible_watch());
  MadeAgain again{.is_planned = true, .faults = faults_against_plan(root, plan)};
  if (options.images == 0) return again;
  Progress progress("images", 0, std::min<std::int64_t>(options.images, image_count(plan)));
  const std::vector<RerenderedImage> images = rerender(
      root, plan, options,
      {.advance = [&](std::int64_t more, const std::string& file) { progress.advance(more, file); }});
  progress.finish();
  keep_rerender(root, {options.samples, options.max_shift_px, options.max_block_rms_px, images});
  std::cout << brief(images) << "\n";
  for (const RerenderedImage& image : images)
    if (!image.fault.empty()) again.faults.push_back(image.file + ": " + image.fault);
  return again;
}

/// Keeps the result for cps report. A folder that may not be written to can be verified all the same.
void keep(const fs::path& root, const VerifySummary& summary, bool is_planned_again) try {
  keep_verification(root, summary, is_planned_again);
} catch (const std::exception& error) {
  std::cout << error.what() << ": cps report will not know of this\n";
}

}  // namespace

const Manual verify_manual{
    .name = "cps verify",
    .summary = "check every file of a dataset against its labels",
    .synopsis = {"DATASET [--rerender N]"},
    .description = R"(
Checks every file of a finished dataset against its labels, and every label
against itself. If the job's file and its scenes are there, plans the dataset
again and compares labels, lists and poses with that plan.

With --rerender N renders N randomly chosen images again through the lens of
their label, ray by ray, and compares them with the stored ones. The results are
kept in .cps/verify.json and .cps/rerender.json in the dataset, for cps report.
)",
    .exit_status = {{"0", "nothing is wrong"}, {"1", "failed, or something is wrong"}, {"2", "wrong usage"}},
    .examples = {{"cps verify data", "checks every file"},
                 {"cps verify data --rerender 20", "also renders twenty images again"}},
    .see_also = {"cps generate", "cps finish", "cps report"},
};

int cps_verify(const Arguments& arguments) {
  RerenderOptions again;
  po::options_description options("Options");
  options.add_options()("dataset", po::value<std::string>()->value_name("DATASET")->required(),
                        "the dataset's folder")("rerender",
                                                po::value(&again.images)->default_value(again.images),
                                                "how many randomly chosen images to render again")(
      "samples", po::value(&again.samples)->default_value(again.samples),
      "samples per pixel of those renders")("seed", po::value(&again.seed)->default_value(again.seed),
                                            "seed of the random choice");
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments, verify_manual, options, positional, values)) return 0;
  po::notify(values);
  if (again.images < 0) throw po::error("--rerender: must not be negative");
  if (again.samples < 1 || again.samples > 65536) throw po::error("--samples: must lie in [1, 65536]");
  const fs::path root = values["dataset"].as<std::string>();
  VerifySummary summary = verify_dataset(root);
  const MadeAgain made = make_again(root, again);
  summary.faults.insert(summary.faults.end(), made.faults.begin(), made.faults.end());
  keep(root, summary, made.is_planned);
  for (const std::string& fault : summary.faults) std::cerr << fault << "\n";
  std::cout << summary.brief() << "\n";
  return summary.faults.empty() ? 0 : 1;
}

}  // namespace cps
