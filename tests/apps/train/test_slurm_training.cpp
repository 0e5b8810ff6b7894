#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/apps/cps_program.h"
#include "tests/apps/dataset/slurm_cluster.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("srun trains with two processes the weights that one trains", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = folder / "city.glb", data = folder / "data";
  REQUIRE(run_cps("city --seed 1 --extent-m 300 -o " + scene.string()).exit_status == 0);
  REQUIRE(run_cps("generate --name t --seed 3 --scene " + scene.string() +
                  " --size 80x45 --base_hfov_deg 60,120 --views 20 --lenses 2 --samples 2 --out " +
                  data.string())
              .exit_status == 0);
  // The last of an epoch's steps has one batch, so one of two processes has none.
  const std::string train = "train --data " + data.string() +
                            " --width 48 --epochs 2 --batch 8 --threads 1 --dropout .25 --augment .3 --out ";
  REQUIRE(run_cps(train + (folder / "one").string() + " --batches-per-step 2").exit_status == 0);
  const std::string weights = read_file(folder / "one" / "weights.pt");

  const SlurmCluster cluster(folder / "cluster");
  for (const std::string nodes : {"1", "2"}) {
    INFO("nodes: " << nodes);
    const fs::path model = folder / ("two_on_" + nodes), log = folder / ("log_" + nodes);
    const int status = shell("srun --immediate=60 -n 2 -N " + nodes + " " + CPS_PROGRAM + " " + train +
                             model.string() + " >" + log.string() + " 2>&1");
    INFO(read_file(log));
    REQUIRE(status == 0);
    const bool is_equal = read_file(model / "weights.pt") == weights;
    CHECK(is_equal);
    CHECK_THAT(read_file(log), Catch::Contains("epoch   2/2"));
  }
}
