#include <catch2/catch.hpp>

#include "tests/apps/cps_program.h"

using namespace cps;

TEST_CASE("a device that is none is refused as wrong usage") {
  for (const std::string verb :
       {"train --data d --out o", "eval --model m --data d", "predict --model m image.png"}) {
    const ProgramRun run = run_cps(verb + " --device gpu");
    INFO(verb << "\n" << run.output);
    CHECK(run.exit_status == 2);
    CHECK(run.output == "cps-train: device 'gpu': must be cpu or cuda\n");
  }
}
