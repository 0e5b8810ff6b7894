#include <sys/mount.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// A rendered dataset and what cps export says of it.
struct Rendered {
  TemporaryFolder temporary;
  fs::path folder = temporary.path, data = folder / "data", out = folder / "out";

  Rendered() { REQUIRE(run_cps(tiny_recipe(write_street_gltf(folder), data)).exit_status == 0); }

  std::string command(const std::string& target, const fs::path& to, const std::string& more = "") const {
    return "export " + data.string() + " --to " + target + " -o " + to.string() + " " + more;
  }
};

}  // namespace

TEST_CASE("cps export writes each layout, says so, and leaves it alone the second time") {
  const Rendered rendered;
  for (const std::string target : {"webdataset", "huggingface", "colmap", "nerfstudio", "kitti", "coco"}) {
    const fs::path out = rendered.folder / target;
    const ProgramRun run = run_cps(rendered.command(target, out));
    INFO(run.output);
    CHECK(run.exit_status == 0);
    CHECK_THAT(run.output, Catch::Contains(out.string() + ": 30 images for " + target));
    CHECK(read_json(out / "export.json").at("format") == target);
    CHECK_THAT(run_cps(rendered.command(target, out)).output, Catch::Contains("nothing to do"));
  }
  CHECK(run_cps("verify " + rendered.data.string()).exit_status == 0);
}

TEST_CASE("cps export refuses unknown targets and options in one line") {
  check_refused("export data --to voc -o out", 2,
                "--to voc: is none of webdataset, huggingface, colmap, nerfstudio, kitti, coco");
  check_refused("export data -o out", 2, "--to");
  check_refused("export data --to kitti", 2, "--out");
  check_refused("export data --to webdataset --shard_mb 0 -o out", 2, "--shard_mb: must lie in");
  check_refused("export data --to colmap --shard_mb 9 -o out", 2, "--shard_mb: is for --to webdataset only");
  check_refused("export data --to kitti --license mit -o out", 2, "--license: is for --to huggingface only");
  check_refused("export /nonexistent --to kitti -o out", 1, "/nonexistent: is not a folder");
  CHECK_FALSE(fs::exists("out"));
}

TEST_CASE("cps export refuses a dataset whose shards are not joined yet") {
  const TemporaryFolder temporary;
  const fs::path data = temporary.path / "data", out = temporary.path / "out";
  REQUIRE(run_cps(tiny_recipe(write_street_gltf(temporary.path), data) + " --shard 0/2").exit_status == 0);
  check_refused("export " + data.string() + " --to kitti -o " + out.string(), 1, "it is not finished");
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("exports that are killed once they have begun end with the same bytes when they are run again") {
  const Rendered rendered;
  for (const std::string target : {"webdataset", "huggingface", "colmap", "coco"}) {
    const fs::path whole = rendered.folder / (target + "_whole");
    REQUIRE(run_cps(rendered.command(target, whole)).exit_status == 0);
    for (int delay_ms : {0, 1, 2, 4, 8, 16}) {
      const pid_t child = start_cps(rendered.command(target, rendered.out));
      const auto has_begun = [&] {
        return fs::exists(rendered.out / ".cps" / "export.json") || fs::exists(rendered.out / "export.json");
      };
      for (int tries = 0; tries < 100'000 && !has_begun(); ++tries)
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
      kill(child, SIGKILL);
      wait_for(child);
      REQUIRE(run_cps(rendered.command(target, rendered.out)).exit_status == 0);
      CHECK(differences(whole, rendered.out) == "");
      CHECK_FALSE(fs::exists(rendered.out / ".cps"));
      fs::remove_all(rendered.out);
    }
  }
}

TEST_CASE("files that may not grow (as on a full disk) stop an export cleanly, and it goes on later") {
  const Rendered rendered;
  const fs::path whole = rendered.folder / "whole";
  for (const std::string target : {"webdataset", "huggingface", "nerfstudio", "coco"}) {
    REQUIRE(run_cps(rendered.command(target, whole)).exit_status == 0);
    for (rlim_t bytes : {100, 3000}) {
      const int status =
          wait_for(start_cps(rendered.command(target, rendered.out), rendered.folder / "output", [&] {
            const rlimit limit{bytes, bytes};
            setrlimit(RLIMIT_FSIZE, &limit);
          }));
      const std::string output = read_file(rendered.folder / "output");
      INFO(target << " " << bytes << "\n" << output);
      CHECK(status == 1);
      CHECK_THAT(output, Catch::StartsWith("cps: ") && Catch::Contains("cannot be written: File too large"));
      CHECK(std::count(output.begin(), output.end(), '\n') == 1);
      CHECK_FALSE(fs::exists(rendered.out / "export.json"));
      const auto complete = contents(whole);
      for (const auto& [name, file] : contents(rendered.out)) CHECK(complete.at(name) == file);
    }
    CHECK(run_cps(rendered.command(target, rendered.out)).exit_status == 0);
    CHECK(differences(whole, rendered.out) == "");
    fs::remove_all(whole);
    fs::remove_all(rendered.out);
  }
}

TEST_CASE("a full disk stops an export cleanly") {
  const Rendered rendered;
  const fs::path whole = rendered.folder / "whole";
  REQUIRE(run_cps(rendered.command("webdataset", whole)).exit_status == 0);
  fs::create_directories(rendered.out);
  if (mount("none", rendered.out.c_str(), "tmpfs", 0, "size=64k") != 0) {
    WARN("NOT TESTED: a full disk: no tmpfs can be mounted here (" << std::strerror(errno) << ")");
    return;
  }
  check_refused(rendered.command("webdataset", rendered.out), 1, "No space left on device");
  // The first file has room on the disk, and is complete.
  CHECK(contents(rendered.out) ==
        std::map{std::pair{std::string("classes.json"), contents(whole).at("classes.json")}});
  CHECK(mount("none", rendered.out.c_str(), "tmpfs", MS_REMOUNT, "size=8m") == 0);
  const ProgramRun run = run_cps(rendered.command("webdataset", rendered.out));
  INFO(run.output);
  CHECK(run.exit_status == 0);
  CHECK(differences(whole, rendered.out) == "");
  umount(rendered.out.c_str());
}
