#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "tests/apps/cps_program.h"
#include "tests/apps/street_gltf.h"
#include "tests/files_in.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

int run_shell(const std::string& command) {
  return std::system(("(" + command + ") >/dev/null 2>&1").c_str());
}

/// Man pages, completion, batch scripts and what Debian asks of a package are in their places.
void check_shared_files(const fs::path& share) {
  for (const char* file :
       {"man/man1/cps.1.gz", "man/man1/cps-generate.1.gz", "man/man1/cps-lens-check.1.gz",
        "man/man1/cps-slurm.1.gz", "bash-completion/completions/cps", "zsh/vendor-completions/_cps",
        "cps/slurm/cps-array.sbatch", "cps/kubernetes/cps-generate.yaml", "cps/kubernetes/cps-finish.yaml",
        "cps/aws-batch/job-definition.json", "cps/aws-batch/generate.json", "cps/aws-batch/finish.json",
        "doc/cps/copyright", "doc/cps/changelog.gz"}) {
    INFO(file);
    CHECK(fs::exists(share / file));
  }
  CHECK(!fs::exists(share / "cps/slurm/cps-slurm.1"));
  CHECK(run_shell("zcat " + (share / "man/man1/cps-generate.1.gz").string() + " | grep -F 'max_zoom'") == 0);
  CHECK(run_shell("bash -n " + (share / "bash-completion/completions/cps").string()) == 0);
}

/// The installed program finds a shipped recipe and its rig by name and makes a dataset.
void check_program(const fs::path& program, const fs::path& folder) {
  const std::string scene = write_street_gltf(folder).string(), out = (folder / "dataset").string();
  CHECK(
      run_shell(
          program.string() + " generate --recipe kitti --scene " + scene +
          " --scale 1e-6 --conditions_per_scene 1 --size 96x40 --hfov_deg 70 --lenses 1 --samples 2 --out " +
          out) == 0);
  CHECK(run_shell(program.string() + " verify " + out) == 0);
  CHECK(fs::exists(fs::path(out) / "96x40_hfov070" / "cam2_lens0000"));
}

}  // namespace

TEST_CASE("what is installed works alone, and uninstalling leaves nothing", "[slow]") {
  const TemporaryFolder folder;
  const fs::path prefix = folder.path / "prefix";
  REQUIRE(run_shell("cmake --install " CPS_BUILD " --component core --prefix " + prefix.string()) == 0);
  CHECK(!fs::exists(prefix / "bin" / "cps-train"));
  check_program(prefix / "bin" / "cps", folder.path);
  CHECK(run_shell((prefix / "bin" / "cps-slurm").string() +
                  " 4 -- --recipe demo 2>&1 | grep -e '--out is missing'") == 0);
  check_shared_files(prefix / "share");
  REQUIRE(run_shell("cmake -DBUILD=" CPS_BUILD " -P " CPS_SOURCE "/cmake/uninstall.cmake") == 0);
  CHECK(files_in(prefix) == 0);
}

TEST_CASE("the .deb of a render node names what it needs, no LibTorch, and works unpacked", "[slow]") {
  const TemporaryFolder folder;
  const std::string f = folder.path.string();
  REQUIRE(run_shell("cd " + f + " && cpack --config " CPS_BUILD "/CPackConfig.cmake -G DEB -B " + f) == 0);
  const std::string deb = "$(ls " + f + "/cps_*.deb)";
  REQUIRE(run_shell("dpkg-deb --field " + deb + " Depends | grep libembree3") == 0);
  REQUIRE(run_shell("dpkg-deb --field " + deb + " Depends | grep torch") != 0);
  REQUIRE(run_shell("dpkg-deb -x " + deb + " " + f + "/root") == 0);
  check_program(folder.path / "root" / "usr" / "bin" / "cps", folder.path);
  check_shared_files(folder.path / "root" / "usr" / "share");
  CHECK(run_shell("dpkg-deb --field " + deb +
                  " Maintainer | grep -E '^The cps contributors <[^<> ]+@[^<> ]+>$'") == 0);
  CHECK(run_shell("dpkg-deb --field " + deb + " Description | grep -E '^ many Brown-Conrady lenses'") == 0);
  CHECK(run_shell(
            "zcat " + f +
            "/root/usr/share/doc/cps/changelog.gz | dpkg-parsechangelog -l - -S Version | grep -x 0.1.0") ==
        0);
}
