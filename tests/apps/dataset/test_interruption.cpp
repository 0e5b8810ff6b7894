#include <catch2/catch.hpp>

#include "random/counter_hash.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Kills generate and finish at random moments, `kills` times, and checks after each that every image in the
/// folder is complete. When a run finishes the dataset, starts over with an empty folder.
void check_kills(int kills, bool by_shards) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "killed";
  REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0);
  const std::vector<std::string> commands =
      by_shards ? std::vector<std::string>{tiny_recipe(scene, out) + " --shard 0/2",
                                           tiny_recipe(scene, out) + " --shard 1/2", "finish " + out.string()}
                : std::vector<std::string>{tiny_recipe(scene, out)};
  const auto whole = contents(folder / "whole");
  int killed = 0;
  std::size_t command = 0;
  for (int i = 0; killed < kills && i < 20 * kills; ++i) {
    const double delay_ms = random_uniform(make_stream(7, by_shards ? "shards" : "kill"), i, 5, 500);
    const int status =
        run_and_signal(commands[command], SIGKILL, std::chrono::milliseconds(std::lround(delay_ms)));
    killed += status == 128 + SIGKILL;
    REQUIRE((status == 0 || status == 128 + SIGKILL));
    for (const auto& [name, bytes] : contents(out))
      if (name.find(".tmp") == name.npos) CHECK((whole.contains(name) && whole.at(name) == bytes));
    if (status == 0 && ++command == commands.size()) {
      CHECK(differences(folder / "whole", out) == "");
      fs::remove_all(out);
      command = 0;
    }
  }
  CHECK(killed == kills);
  for (; command < commands.size(); ++command) REQUIRE(run_cps(commands[command]).exit_status == 0);
  CHECK(differences(folder / "whole", out) == "");
}

/// Output and exit status of generate, sent a signal once it prints that it began.
ProgramRun stopped(const std::string& arguments, int signal, const fs::path& output) {
  fs::remove(output);  // of an earlier run
  const pid_t child = start_cps(arguments, output);
  const auto has_begun = [&] {
    return fs::exists(output) && read_file(output).find("to make") != std::string::npos;
  };
  while (!has_begun() && waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(child, signal);
  ProgramRun run{.exit_status = wait_for(child), .output = read_file(output)};
  return run;
}

}  // namespace

TEST_CASE("killed at any moment and run again, generate ends with the uninterrupted dataset") {
  check_kills(5, false);
}

TEST_CASE("the same with shards and finish") {
  check_kills(5, true);
}

TEST_CASE("a hundred kills of generate", "[slow]") {
  check_kills(100, false);
}

TEST_CASE("a hundred kills of shards and finish", "[slow]") {
  check_kills(100, true);
}

TEST_CASE("SIGTERM and SIGINT end generate cleanly with 75, to be run again") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  // A few seconds of work, so that there is something to interrupt.
  const auto recipe = [&](const char* out) { return tiny_recipe(scene, folder / out, 256); };
  for (int signal : {SIGTERM, SIGINT}) {
    const ProgramRun run = stopped(recipe("stopped"), signal, folder / "output");
    INFO(run.output);
    CHECK(run.exit_status == 75);
    CHECK_THAT(run.output, Catch::EndsWith("interrupted; run the same command again to go on\n"));
  }
  for (const auto& [name, bytes] : contents(folder / "stopped")) CHECK(name.find(".tmp") == name.npos);
  REQUIRE(run_cps(recipe("stopped")).exit_status == 0);
  REQUIRE(run_cps(recipe("whole")).exit_status == 0);
  CHECK(differences(folder / "whole", folder / "stopped") == "");
}
