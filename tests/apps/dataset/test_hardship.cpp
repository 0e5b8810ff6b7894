#include <sys/mount.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "dataset/job/journal.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

/// Failures that occur on a render farm. Each is reported in one line, leaves no incomplete file under a
/// final name, and once it is removed the same command completes the job.
namespace {

struct Trouble {
  TemporaryFolder temporary;
  fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  std::string recipe = tiny_recipe(scene, out);

  Trouble() { REQUIRE(run_cps(tiny_recipe(scene, folder / "whole")).exit_status == 0); }

  /// Runs the recipe, which must fail in one line that contains `expected`.
  void check_fails(
      const std::string& expected, const std::function<void()>& prepare = [] {}) {
    const int status = wait_for(start_cps(recipe, folder / "output", prepare));
    const std::string output = read_file(folder / "output");
    INFO(output);
    CHECK(status == 1);
    CHECK_THAT(output, Catch::Contains(expected));
    const std::size_t error = output.find("cps: ");
    REQUIRE(error != output.npos);
    CHECK(output.find('\n', error) == output.size() - 1);  // the last line
    check_what_is_there();
  }

  void check_what_is_there() const {
    const auto whole = contents(folder / "whole");
    for (const auto& [name, bytes] : contents(out)) {
      INFO(name);
      CHECK((whole.contains(name) && whole.at(name) == bytes));
    }
    CHECK_FALSE(fs::exists(out / "dataset.json"));
  }

  void check_recovers() const {
    const ProgramRun run = run_cps(recipe);
    INFO(run.output);
    CHECK(run.exit_status == 0);
    CHECK(differences(folder / "whole", out) == "");
  }

  std::size_t made() const { return read_journals(out).views.size(); }
};

}  // namespace

TEST_CASE("files that may not grow (as on a full disk) stop generate cleanly") {
  Trouble trouble;
  for (rlim_t bytes : {300, 2500, 6000})
    trouble.check_fails("cannot be written", [&] {
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    });
  trouble.check_recovers();
}

TEST_CASE("a full disk stops generate cleanly") {
  Trouble trouble;
  fs::create_directories(trouble.out);
  if (mount("none", trouble.out.c_str(), "tmpfs", 0, "size=96k") != 0) {
    WARN("NOT TESTED: a full disk: no tmpfs can be mounted here (" << std::strerror(errno) << ")");
    return;
  }
  trouble.check_fails("No space left on device");
  const std::size_t before = trouble.made();
  CHECK(before < 10);
  CHECK(mount("none", trouble.out.c_str(), "tmpfs", MS_REMOUNT, "size=4m") == 0);
  trouble.check_recovers();
  umount(trouble.out.c_str());
}

TEST_CASE("a folder that may not be written to is named") {
  Trouble trouble;
  fs::permissions(trouble.folder, fs::perms(0777));
  fs::create_directories(trouble.out);
  fs::permissions(trouble.out, fs::perms(0555));
  const auto as_nobody = [] {
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(126);
  };
  if (wait_for(start_cps("help", trouble.folder / "output", as_nobody)) != 0) {
    WARN("NOT TESTED: a folder that may not be written to: another user cannot run " << CPS_PROGRAM);
    return;
  }
  trouble.check_fails("cannot be written: Permission denied", as_nobody);
  CHECK(fs::is_empty(trouble.out));
  fs::permissions(trouble.out, fs::perms(0755));
  trouble.check_recovers();
}

TEST_CASE("a scene that vanished is named, and once it is back the job continues") {
  Trouble trouble;
  REQUIRE(run_cps(trouble.recipe + " --shard 0/2").exit_status == 0);
  fs::rename(trouble.scene, trouble.folder / "away");
  trouble.check_fails("street.gltf: there is no such file");
  check_refused("finish " + trouble.out.string(), 1, "street.gltf: there is no such file");
  std::string other = read_file(trouble.folder / "away");
  write_file(trouble.scene, other + "\n");
  trouble.check_fails("sha256 of street.gltf");
  fs::rename(trouble.folder / "away", trouble.scene);
  trouble.check_recovers();
  fs::remove(trouble.scene);  // a finished dataset needs it no more
  CHECK_THAT(run_cps(trouble.recipe).output, Catch::Contains("nothing to do"));
}

TEST_CASE("finish reports an image that is cut short or lost, and generate makes it again") {
  Trouble trouble;
  for (const char* shard : {" --shard 0/2", " --shard 1/2"})
    REQUIRE(run_cps(trouble.recipe + shard).exit_status == 0);
  fs::resize_file(trouble.out / "80x45_hfov060/front_lens0000/000000.png", 100);
  fs::remove(trouble.out / "80x45_hfov120/front_lens0000/000004.png");
  const ProgramRun finish = run_cps("finish " + trouble.out.string());
  CHECK(finish.exit_status == 1);
  CHECK_THAT(finish.output, Catch::Contains("2 of 10 views are missing"));
  trouble.check_recovers();
}

TEST_CASE("damaged journal lines are reported and their views made again") {
  Trouble trouble;
  for (const char* shard : {" --shard 0/2", " --shard 1/2"})
    REQUIRE(run_cps(trouble.recipe + shard).exit_status == 0);
  const fs::path journal = trouble.out / ".cps" / "journal_1_of_2.jsonl";
  std::string text = read_file(journal);
  text[20] ^= 1;
  write_file(journal, text + "not even JSON\n");
  CHECK(run_cps("finish " + trouble.out.string()).exit_status == 1);
  CHECK_THAT(run_cps(trouble.recipe + " --shard 1/2").output,
             Catch::Contains("2 damaged lines in the journals") && Catch::Contains("1 views to make"));
  CHECK(run_cps("finish " + trouble.out.string()).exit_status == 0);
  CHECK(differences(trouble.folder / "whole", trouble.out) == "");
}

TEST_CASE("finishing removes the temporary files that a power cut leaves") {
  Trouble trouble;
  REQUIRE(run_cps(trouble.recipe + " --shard 0/2").exit_status == 0);
  write_file(trouble.out / "80x45_hfov060/front_lens0000/000009.png.0123cdef-5.tmp", std::string("half"));
  trouble.check_recovers();
}
