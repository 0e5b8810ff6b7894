#include <algorithm>
#include <catch2/catch.hpp>

#include "dataset/job/journal.h"
#include "random/shuffle.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> shards_in_drawn_order(int count, std::uint64_t seed) {
  std::vector<std::string> shards;
  for (int i = 0; i < count; ++i) shards.push_back(std::to_string(i) + "/" + std::to_string(count));
  shuffle(shards, make_stream(seed, "order"));
  return shards;
}

/// Makes the tiny recipe in shards, finishes it, and compares it with the dataset of a single run.
void check_shards(const fs::path& scene, const fs::path& whole, const fs::path& out, int count, int threads) {
  INFO(count << " shards, " << threads << " threads");
  for (const std::string& shard : shards_in_drawn_order(count, count + 100 * threads)) {
    const ProgramRun run =
        run_cps(tiny_recipe(scene, out) + " --shard " + shard + " --threads " + std::to_string(threads));
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    CHECK_FALSE(fs::exists(out / "dataset.json"));
  }
  const ProgramRun finished = run_cps("finish " + out.string());
  INFO(finished.output);
  REQUIRE(finished.exit_status == 0);
  CHECK(differences(whole, out) == "");
}

}  // namespace

TEST_CASE("shards in any order, finished, are the dataset that one process makes") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0);
  check_shards(scene, folder / "whole", folder / "three", 3, 2);
  check_shards(scene, folder / "whole", folder / "many", 25, 1);  // more shards than views
  CHECK_THAT(run_cps("finish " + (folder / "many").string()).output, Catch::Contains("nothing to do"));
}

TEST_CASE("1, 2, 3 and 7 shards of 1, 2 and 16 threads make the same bytes", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0);
  for (int threads : {1, 2, 16}) {
    const fs::path one = folder / ("one" + std::to_string(threads));
    REQUIRE(run_cps(tiny_recipe(scene, one) + " --threads " + std::to_string(threads)).exit_status == 0);
    CHECK(differences(folder / "whole", one) == "");
    for (int count : {2, 3, 7})
      check_shards(scene, folder / "whole", folder / (std::to_string(count) + "x" + std::to_string(threads)),
                   count, threads);
  }
}

TEST_CASE(
    "shards of a recipe with several scenes make the dataset of one process, each from its own scenes") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path;
  write_street_gltf(folder);
  std::string scenes;
  for (int i = 0; i < 5; ++i) {
    const fs::path scene = folder / ("street" + std::to_string(i) + ".gltf");
    fs::copy_file(folder / "street.gltf", scene);
    scenes += (i > 0 ? "," : "") + scene.string();
  }
  const auto recipe = [&](const fs::path& out) {
    return "generate --name t --seed 3 --scene " + scenes +
           " --size 80x45 --base_hfov_deg 60,120 --views 10 --lenses 2 --samples 2 --out " + out.string();
  };
  REQUIRE(run_cps(recipe(folder / "whole")).exit_status == 0);
  for (int count : {2, 5, 7}) {
    const fs::path out = folder / std::to_string(count);
    std::size_t looked_at = 0;
    for (int i = 0; i < count; ++i) {
      const fs::path look = folder / ("look" + std::to_string(count) + "_" + std::to_string(i));
      fs::create_directories(look);
      const ProgramRun run = run_cps(recipe(out) + " --look " + look.string() + " --shard " +
                                     std::to_string(i) + "/" + std::to_string(count));
      INFO(run.output);
      REQUIRE(run.exit_status == 0);
      looked_at += contents(look).size();
    }
    CHECK(looked_at >= 5);
    CHECK(looked_at < 5u + count);  // neighbours have at most one scene in common
    REQUIRE(run_cps("finish " + out.string()).exit_status == 0);
    CHECK(differences(folder / "whole", out) == "");
  }
  // A shard whose views are made has no scene to look at.
  fs::remove(folder / "7" / "dataset.json");
  const fs::path look = folder / "look";
  fs::create_directories(look);
  CHECK_THAT(run_cps(recipe(folder / "7") + " --look " + look.string() + " --shard 3/7").output,
             Catch::Contains("0 views to make"));
  CHECK(contents(look).empty());
}

TEST_CASE("what was made under one sharding counts under another, and finish says what is missing") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  check_refused("finish " + out.string(), 1, "no cps generate was begun");
  REQUIRE(run_cps(tiny_recipe(scene, out) + " --shard 0/2").exit_status == 0);
  const ProgramRun half = run_cps("finish " + out.string());
  INFO(half.output);
  CHECK(half.exit_status == 1);
  CHECK_THAT(half.output, Catch::Contains("shard 1/2: 5 of 5 views are missing, the first in 80x45_hfov") &&
                              Catch::Contains("5 of 10 views are missing"));
  CHECK_FALSE(fs::exists(out / "dataset.json"));

  // The half that is not made is split further; the quarters of the half that is made have nothing to do.
  CHECK_THAT(run_cps(tiny_recipe(scene, out) + " --shard 1/4").output, Catch::Contains("0 views to make"));
  CHECK_THAT(run_cps(tiny_recipe(scene, out) + " --shard 2/4").output,
             Catch::Contains("views to make") && !Catch::Contains(" 0 views"));
  const ProgramRun rest = run_cps(tiny_recipe(scene, out));  // the rest, unsharded, which finishes
  INFO(rest.output);
  CHECK(rest.exit_status == 0);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
  CHECK_THAT(run_cps(tiny_recipe(scene, out) + " --shard 3/4").output, Catch::Contains("nothing to do"));
}

TEST_CASE("finish needs nothing but the folder, from wherever it is run") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  fs::create_directories(folder / "elsewhere");
  const std::string from = "cd " + folder.string() + " && ";
  const std::string relative = tiny_recipe("street.gltf", "dataset") + " --rig " + CPS_RECIPES + "/kitti.rig";
  const auto run_in = [&](const char* where, const std::string& arguments) {
    const std::string command = "cd " + (folder / where).string() + " && " + CPS_PROGRAM + " " + arguments +
                                " >" + (folder / "output").string() + " 2>&1";
    return std::system(command.c_str());
  };
  for (const char* shard : {" --shard 0/2", " --shard 1/2"}) REQUIRE(run_in(".", relative + shard) == 0);
  CHECK(run_in("elsewhere", "finish ../dataset") == 0);
  INFO(read_file(folder / "output"));
  const ProgramRun verified = run_cps("verify " + (folder / "dataset").string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
}

TEST_CASE("a shard that another process makes is refused; overlapping ones do no harm") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0);
  REQUIRE(run_cps(tiny_recipe(scene, out) + " --shard 0/9").exit_status == 0);
  {
    const FileLock held(out / ".cps" / "journal_1_of_3.jsonl", FileLock::Kind::exclusive);
    const ProgramRun refused = run_cps(tiny_recipe(scene, out) + " --shard 1/3");
    CHECK(refused.exit_status == 75);
    CHECK_THAT(refused.output, Catch::Contains("shard 1/3 is being made by another process"));
    const FileLock working(folder_lock(out), FileLock::Kind::shared);
    const ProgramRun busy = run_cps("finish " + out.string());
    CHECK(busy.exit_status == 75);
    CHECK_THAT(busy.output, Catch::Contains("other processes still work there"));
  }
  std::vector<pid_t> together;
  for (const char* shard : {"0/2", "1/2", "0/3", "1/3", "2/3"})
    together.push_back(start_cps(tiny_recipe(scene, out) + " --shard " + shard));
  for (pid_t process : together) CHECK(wait_for(process) == 0);
  REQUIRE(run_cps("finish " + out.string()).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}

TEST_CASE("shards that start at once make a recipe's cities once", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, out = folder / "dataset";
  const std::string recipe =
      "generate --seed 4 --city_seed 1,2 --size 64x36 --base_hfov_deg 70 --views 3 --lenses 1 --samples 2 "
      "--out ";
  std::vector<pid_t> together;
  for (const char* shard : {"0/3", "1/3", "2/3"})
    together.push_back(start_cps(recipe + out.string() + " --shard " + shard));
  for (pid_t process : together) CHECK(wait_for(process) == 0);
  REQUIRE(run_cps("finish " + out.string()).exit_status == 0);
  REQUIRE(run_cps(recipe + (folder / "whole").string()).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}

TEST_CASE("a shard out of range is wrong usage") {
  const TemporaryFolder temporary;
  const fs::path scene = write_street_gltf(temporary.path);
  for (const char* shard : {"2/2", "1", "-1/2", "a/b", "0/0"})
    check_refused(tiny_recipe(scene, temporary.path / "d") + " --shard " + shard, 2,
                  "--shard " + std::string(shard));
  CHECK_FALSE(fs::exists(temporary.path / "d"));
}
