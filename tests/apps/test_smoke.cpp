#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/apps/cps_program.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

// The training split shares neither streets nor lenses with the test split, so the network can only use the
// appearance of the distortion. The images are less than half the recipe's size, still above the network's
// input of 160 × 90.
TEST_CASE("on the smoke recipe a network beats the training mean's H-FOV error by a quarter", "[slow]") {
  const cps::TemporaryFolder folder;
  const std::string data = folder.path / "data", model = folder.path / "model";
  cps::require_success("generate --recipe " CPS_RECIPES "/smoke.cfg --size 208x117 --out " + data);
  cps::require_success("verify " + data);
  cps::require_success("train --data " + data + " --out " + model + " --preset smoke --minutes 9");
  cps::require_success("eval --data " + data + " --model " + model);
  const auto errors = nlohmann::json::parse(std::ifstream(model + "/eval.json"));
  CHECK(errors.at("network").at("images") >= 200);
  CHECK(errors.at("network").at("hfov_deg").at("mean") <=
        0.75 * errors.at("training_mean").at("hfov_deg").at("mean").get<double>());
}
