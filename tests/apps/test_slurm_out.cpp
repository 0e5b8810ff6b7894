#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

void write_program(const fs::path& file, const std::string& script) {
  write_file(file, "#!/bin/sh\n" + script + "\n");
  fs::permissions(file, fs::perms::owner_all);
}

}  // namespace

TEST_CASE("cps-slurm finishes the folder that is named, however the option is written") {
  const TemporaryFolder folder;
  const fs::path calls = folder.path / "calls";
  write_program(folder.path / "scontrol", "echo MaxArraySize = 1001");
  write_program(folder.path / "sbatch", "echo \"$@\" >> " + calls.string() + "; echo 7");
  for (const char* option :
       {"--out data", "--out=data", "--output data", "--output=data", "-o data", "-odata"}) {
    INFO(option);
    fs::remove(calls);
    CHECK(std::system(("PATH=" + folder.path.string() +
                       ":$PATH CPS=true " CPS_SOURCE "/apps/slurm/cps-slurm 2 -- --recipe demo " + option +
                       " >/dev/null")
                          .c_str()) == 0);
    const std::string submitted = read_file(calls);
    CHECK_THAT(submitted, Catch::Contains("cps-array.sbatch --recipe demo " + std::string(option) + "\n"));
    CHECK_THAT(submitted, Catch::EndsWith("cps-finish.sbatch data\n"));
  }
}

TEST_CASE("cps-slurm passes on names with spaces and other letters whole") {
  const TemporaryFolder folder;
  const fs::path calls = folder.path / "calls";
  write_program(folder.path / "scontrol", "echo MaxArraySize = 1001");
  write_program(folder.path / "sbatch", "printf '<%s>' \"$@\" >> '" + calls.string() + "'; echo 7");
  CHECK(
      std::system(("PATH=" + folder.path.string() +
                   ":$PATH CPS=true " CPS_SOURCE
                   "/apps/slurm/cps-slurm 2 -- --recipe 'mein Rezept.cfg' --out 'Straßen am Fluß' >/dev/null")
                      .c_str()) == 0);
  const std::string submitted = read_file(calls);
  CHECK_THAT(submitted, Catch::Contains("<--recipe><mein Rezept.cfg><--out><Straßen am Fluß>"));
  CHECK_THAT(submitted, Catch::EndsWith("<Straßen am Fluß>"));
}
