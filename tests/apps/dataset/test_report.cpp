#include <catch2/catch.hpp>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("report writes a page that knows what generate and verify did, and changes no other file") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset",
                 page = folder / "page.html";
  REQUIRE(run_cps(tiny_recipe(scene, out) + " --shard 0/2").exit_status == 0);
  check_refused("report " + out.string() + " -o " + page.string(), 1,
                "is not finished; run cps generate again");
  CHECK_FALSE(fs::exists(page));
  REQUIRE(run_cps(tiny_recipe(scene, out)).exit_status == 0);
  const auto before = contents(out);
  REQUIRE(run_cps("verify " + out.string()).exit_status == 0);
  const ProgramRun run = run_cps("report " + out.string() + " -o " + page.string());
  INFO(run.output);
  REQUIRE(run.exit_status == 0);
  CHECK_THAT(run.output, Catch::StartsWith(page.string() + ": "));
  CHECK(contents(out) == before);
  const std::string html = read_file(page);
  CHECK_THAT(html, Catch::Contains("<b>30</b>images") && Catch::Contains("Verified: no faults.") &&
                       Catch::Contains("compared with the recipe's plan, made again") &&
                       Catch::Contains("Runs: 2;") && Catch::Contains("<tr><td>0/2<td>") &&
                       Catch::Contains("<tr><td>0/1<td>"));
  // The default is a file in the dataset, with the same bytes.
  REQUIRE(run_cps("report " + out.string()).exit_status == 0);
  CHECK(read_file(out / "report.html") == html);
  CHECK(run_cps("verify " + out.string()).exit_status == 0);

  check_refused("report " + out.string() + " -o " + (page / "x.html").string(), 1,
                "x.html: cannot be written");
  check_refused("report " + out.string() + " -o " + folder.string(), 1, "is a folder; name a file to write");
  check_refused("report " + out.string() + " --lenses 0", 2, "--lenses: must lie in [1, 2000]");
  check_refused("report " + (folder / "none").string(), 1, "is not a folder; name a dataset");
}
