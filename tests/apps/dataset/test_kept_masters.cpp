#include <catch2/catch.hpp>

#include "dataset/job/masters.h"
#include "dataset/job/recipe_json.h"
#include "dataset/pixels/master_file.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

std::string keeping(const fs::path& scene, const fs::path& out) {
  return tiny_recipe(scene, out) + " --keep_masters true";
}

}  // namespace

TEST_CASE("kept masters change no image, verify, and have the same bytes from one thread and three") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "plain")).exit_status == 0);
  REQUIRE(run_cps(keeping(scene, folder / "one") + " --threads 1").exit_status == 0);
  REQUIRE(run_cps(keeping(scene, folder / "three") + " --threads 3").exit_status == 0);
  CHECK(differences(folder / "one", folder / "three") == "");

  const auto plain = contents(folder / "plain"), kept = contents(folder / "one");
  for (const auto& [name, bytes] : plain)
    if (name != "dataset.json") CHECK((kept.contains(name) && kept.at(name) == bytes));
  CHECK(kept.size() == plain.size() + 10 + 1);  // a master a view, and their table

  const std::vector<KeptMaster> masters = read_masters(folder / "one");
  REQUIRE(masters.size() == 10);
  for (const KeptMaster& master : masters) {
    const NoisyMaster pixels = read_master(folder / "one" / master.file);
    CHECK(pixels.picture.spec().width == master.camera.width);
    CHECK(pixels.picture.spec().height == master.camera.height);
    CHECK(hfov_rad(master.base) >= hfov_rad(master.set) * (1 - 1e-12));
    CHECK(master.camera.fx > 1.5 * master.base.fx);  // oversampled
  }
  CHECK(read_recipe(folder / "one").keep_masters);

  const ProgramRun verified = run_cps("verify " + (folder / "one").string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  CHECK_THAT(verified.output, Catch::Contains("30 images") && Catch::Contains("10 masters"));
}

TEST_CASE("verify finds a master that is damaged or lost") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  REQUIRE(run_cps(keeping(scene, out)).exit_status == 0);
  const fs::path file = out / read_masters(out)[3].file;
  const auto check_found = [&](const char* what) {
    const ProgramRun verified = run_cps("verify " + out.string());
    INFO(verified.output);
    CHECK(verified.exit_status == 1);
    CHECK_THAT(verified.output,
               Catch::Contains(file.lexically_relative(out).string()) && Catch::Contains(what));
  };
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] ^= 1;
  write_file(file, bytes);
  check_found("sha256 in masters.csv");
  fs::remove(file);
  check_found("1 faults");
}

TEST_CASE("killed at any moment and run again, generate ends with all masters") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "killed";
  REQUIRE(run_cps(keeping(scene, folder / "whole")).exit_status == 0);
  const auto whole = contents(folder / "whole");
  for (int delay_ms : {60, 110, 170, 240, 320}) {
    const int status = run_and_signal(keeping(scene, out), SIGKILL, std::chrono::milliseconds(delay_ms));
    REQUIRE((status == 0 || status == 128 + SIGKILL));
    for (const auto& [name, bytes] : contents(out))
      if (name.find(".tmp") == name.npos) CHECK((whole.contains(name) && whole.at(name) == bytes));
  }
  REQUIRE(run_cps(keeping(scene, out)).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}

TEST_CASE("shards keep their masters, finish lists them, and misses one that is gone") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "shards";
  REQUIRE(run_cps(keeping(scene, folder / "whole")).exit_status == 0);
  for (const char* shard : {" --shard 0/2", " --shard 1/2"})
    REQUIRE(run_cps(keeping(scene, out) + shard).exit_status == 0);
  fs::remove(out / read_masters(folder / "whole")[7].file);
  const ProgramRun early = run_cps("finish " + out.string());
  CHECK(early.exit_status == 1);
  CHECK_THAT(early.output, Catch::Contains("1 of 10 views are missing"));
  REQUIRE(run_cps(keeping(scene, out) + " --shard 1/2").exit_status == 0);
  REQUIRE(run_cps("finish " + out.string()).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}
