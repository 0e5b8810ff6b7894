#include "dataset/job/finish.h"

#include <iostream>

#include "apps/dataset/dataset_argument.h"
#include "apps/interruption.h"
#include "apps/verbs.h"
#include "dataset/job/gaps.h"
#include "dataset/job/journal.h"
#include "production/dataset_job.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

int finish(const fs::path& root) {
  const std::string name = root.string();
  if (is_finished(root)) {
    std::cout << name << ": is finished; nothing to do\n";
    return 0;
  }
  DatasetJob job = job_of_folder(root);
  const FileLock folder(folder_lock(root), FileLock::Kind::exclusive);
  if (!folder.is_held())
    throw HeldByAnother(name + ": other processes still work there; run it again when they are done");
  prepare_scenes(job, root);
  const Plan plan = plan_of(job, interruptible_watch());
  const JournalLines journals = read_journals(root);
  const Gaps gaps = find_gaps(root, plan, journals.views);
  if (!gaps.views.empty()) {
    for (const std::string& line : gaps.lines) std::cerr << name << ": " << line << "\n";
    return 1;
  }
  finish_dataset(root, plan, journals.views, job.scene_sha256);
  std::cout << name << ": finished: " << plan.views.size() << " views, " << image_count(plan) << " images\n";
  return 0;
}

}  // namespace

const Manual finish_manual{
    .name = "cps finish",
    .summary = "join the shards of a dataset",
    .synopsis = {"DATASET"},
    .description = R"(
Completes a dataset whose shares cps generate --shard made, on any number of
machines: joins the journals, and either lists the views that are missing or
writes the split lists and dataset.json. Recipe and scenes are those that the
folder was begun with.
)",
    .exit_status = {{"0", "finished"},
                    {"1", "failed, or views are missing"},
                    {"2", "wrong usage"},
                    {"75", "interrupted, or other processes still work there: run it again"}},
    .examples = {{"cps finish /share/data", "joins what the shards in /share/data made"}},
    .see_also = {"cps generate", "cps verify", "cps-slurm"},
};

int cps_finish(const Arguments& arguments) {
  const std::optional<std::string> root = dataset_argument(arguments, finish_manual);
  return root ? run_interruptible(*root, [&] { return finish(*root); }) : 0;
}

}  // namespace cps
