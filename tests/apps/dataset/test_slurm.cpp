#include <catch2/catch.hpp>

#include "dataset/job/journal.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/dataset/slurm_cluster.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

bool wait_until(const std::function<bool()>& holds, int seconds) {
  for (int i = 0; i < 10 * seconds; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

bool queue_is_empty() {
  return shell("squeue -h | grep -q .") != 0;
}

/// Whether a shard of four has made a view and works on the next.
bool is_at_work(const fs::path& dataset, int shard) {
  const std::string name = std::to_string(shard);
  const fs::path journal = dataset / ".cps" / ("journal_" + name + "_of_4.jsonl");
  return fs::exists(journal) && fs::file_size(journal) > 0 &&
         shell("pgrep -f '[-]-shard " + name + "/4' >/dev/null") == 0;
}

std::string logs_in(const fs::path& folder) {
  std::string text;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".log")
      text += entry.path().filename().string() + ":\n" + read_file(entry.path());
  return text;
}

std::string submit(const fs::path& folder, const std::string& generate) {
  return "cd " + folder.string() + " && " + CPS_SOURCE + "/apps/slurm/cps-slurm 4 -- " + generate;
}

}  // namespace

TEST_CASE("Slurm makes what one process makes, though it loses a task and a node", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = folder / "city.glb", out = folder / "dataset";
  REQUIRE(run_cps("city --seed 1 --extent-m 300 -o " + scene.string()).exit_status == 0);
  const std::string recipe = "--name t --seed 3 --scene " + scene.string() +
                             " --size 240x135 --base_hfov_deg 60,100 --views 20 --lenses 2 "
                             "--conditions_per_scene 2 --samples 4 --out ";
  const SlurmCluster cluster(folder / "cluster");

  REQUIRE(shell(submit(folder, recipe + out.string())) == 0);
  for (int shard = 0; shard < 4; ++shard) {
    INFO("shard " << shard << "\n" << logs_in(folder));
    REQUIRE(wait_until([&] { return is_at_work(out, shard); }, 120));
  }
  CHECK(shell("pkill -9 -f '[-]-shard 0/4'") == 0);
  CHECK(cluster.control("lose", "node2") == 0);
  const bool is_over = wait_until(queue_is_empty, 400);
  const std::string logs = logs_in(folder);
  INFO(logs);
  REQUIRE(is_over);
  CHECK_THAT(logs, Catch::Contains("shard 0/4 ended with 137; back into the queue") &&
                       Catch::Contains("120 images, 0 faults"));

  REQUIRE(run_cps("generate " + recipe + (folder / "whole").string()).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}

TEST_CASE("a cancelled array is not queued again; a shard that fails for good ends the others", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = folder / "city.glb";
  REQUIRE(run_cps("city --seed 1 --extent-m 300 -o " + scene.string()).exit_status == 0);
  const std::string recipe = "--scene " + scene.string() +
                             " --size 240x135 --base_hfov_deg 60 --views 200 --lenses 1 --samples 4 --out " +
                             (folder / "dataset").string();
  const SlurmCluster cluster(folder / "cluster");
  REQUIRE(shell(submit(folder, recipe)) == 0);
  REQUIRE(wait_until([&] { return is_at_work(folder / "dataset", 0); }, 120));
  REQUIRE(shell("scancel -u $(id -un)") == 0);
  CHECK(wait_until(queue_is_empty, 60));
  std::this_thread::sleep_for(std::chrono::seconds(15));  // a queued one would wait for 6 s
  INFO(logs_in(folder));
  CHECK(queue_is_empty());

  REQUIRE(shell(submit(folder, recipe + " --views 0")) == 0);
  CHECK(wait_until(queue_is_empty, 120));
  CHECK_THAT(logs_in(folder), Catch::Contains("cps: ") && Catch::Contains("views"));
  CHECK_FALSE(fs::exists(folder / "dataset" / "dataset.json"));
}

TEST_CASE("cps-slurm reports wrong arguments in one line") {
  const TemporaryFolder temporary;
  const fs::path said = temporary.path / "said";
  const auto refuses = [&](const std::string& arguments, const std::string& why) {
    const int status =
        shell(std::string(CPS_SOURCE) + "/apps/slurm/cps-slurm " + arguments + " 2>" + said.string());
    INFO(arguments << "\n" << read_file(said));
    CHECK(status == 2);
    CHECK_THAT(read_file(said), Catch::StartsWith("cps-slurm: ") && Catch::Contains(why));
  };
  refuses("", "usage");
  refuses("0 -- --recipe demo --out d", "usage");
  refuses("--recipe demo --out d", "usage");
  refuses("4 --recipe demo --out d", "usage");
  refuses("4 -- --recipe demo", "--out is missing");
}
