#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/apps/cps_program.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace {

void require_success(const std::string& arguments) {
  const cps::ProgramRun run = cps::run_cps(arguments);
  INFO("cps " << arguments << "\n" << run.output);
  REQUIRE(run.exit_status == 0);
}

}  // namespace

// The training split shares neither streets nor lenses with the test split, so the network can only use the
// appearance of the distortion. Half the recipe's image size is still above the network's input, 160 × 90.
TEST_CASE("on the smoke recipe a network beats the training mean's H-FOV error by a quarter", "[slow]") {
  const cps::TemporaryFolder folder;
  const std::string data = folder.path / "data", model = folder.path / "model";
  require_success("generate --recipe " CPS_RECIPES "/smoke.cfg --size 240x136 --out " + data);
  require_success("verify " + data);
  require_success("train --data " + data + " --out " + model + " --preset smoke --minutes 9");
  require_success("eval --data " + data + " --model " + model);
  const auto errors = nlohmann::json::parse(std::ifstream(model + "/eval.json"));
  CHECK(errors.at("network").at("images") >= 200);
  CHECK(errors.at("network").at("hfov_deg").at("mean") <=
        0.75 * errors.at("training_mean").at("hfov_deg").at("mean").get<double>());
}
