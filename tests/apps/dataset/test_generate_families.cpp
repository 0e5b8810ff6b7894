#include <catch2/catch.hpp>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Views through fisheyes, of which some do not show the corners of their square images.
std::string fisheye_recipe(const fs::path& scene, const fs::path& out, int samples = 2) {
  return fmt::format(
      "generate --name f --seed 3 --scene {} --size 96x96 --hfov_deg 120,195 --views 3 --lenses 5 --lens_model "
      "kannala_brandt --labels depth,rays,semantic --samples {} --out {}",
      scene.string(), samples, out.string());
}

}  // namespace

TEST_CASE("a dataset of fisheyes is generated and verified and shown and finished from shards", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "whole";
  const ProgramRun made = run_cps(fisheye_recipe(scene, out) + " --threads 1");
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  CHECK_THAT(made.output, Catch::Contains("6 views, 30 groups, 30 images"));
  CHECK(fs::exists(out / "96x96_kannala_brandt_hfov195" / "front_lens0030" / "calibration.json"));
  CHECK(read_json(out / "dataset.json")["is_cps"] == false);
  int masks = 0;
  for (const auto& [name, bytes] : contents(out)) masks += name.ends_with("/valid.png");
  CHECK(masks > 0);
  const ProgramRun verified = run_cps("verify " + out.string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  CHECK_THAT(verified.output, Catch::Contains("30 images, 90 dense labels, 0 faults"));
  CHECK(run_cps("contact-sheet " + out.string() + " -o " + (folder / "sheet.png").string()).exit_status == 0);

  const fs::path sharded = folder / "sharded";
  for (const char* shard : {"1/2", "0/2"})
    REQUIRE(run_cps(fisheye_recipe(scene, sharded) + " --threads 2 --shard " + shard).exit_status == 0);
  REQUIRE(run_cps("finish " + sharded.string()).exit_status == 0);
  CHECK(differences(out, sharded) == "");

  const std::string refusal =
      "calibration.json: model: is kannala_brandt: only datasets of brown_conrady lenses";
  check_refused("report " + out.string(), 1, refusal);
  check_refused("migrate " + out.string(), 1, refusal);
  check_refused("export " + out.string() + " --to colmap -o " + (folder / "x").string(), 1, refusal);
}

TEST_CASE("a run through fisheyes that is killed again and again ends with the same bytes", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  REQUIRE(run_cps(fisheye_recipe(scene, folder / "whole", 4)).exit_status == 0);
  for (int i = 1; i <= 4; ++i)
    run_and_signal(fisheye_recipe(scene, folder / "killed", 4), SIGKILL, std::chrono::milliseconds(400 * i));
  const ProgramRun last = run_cps(fisheye_recipe(scene, folder / "killed", 4));
  INFO(last.output);
  CHECK(last.exit_status == 0);
  CHECK(differences(folder / "whole", folder / "killed") == "");
}

TEST_CASE("fisheye images rendered again through their labels agree and an altered focal length is found",
          "[slow]") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  const ProgramRun made =
      run_cps("generate --seed 3 --scene " + scene.string() +
              " --size 240x180 --hfov_deg 150 --views 3 --lenses 1 --samples 16 --lens_model "
              "unified_spherical --out " +
              out.string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  const std::string verify = "verify " + out.string() + " --rerender 3 --samples 64";
  const ProgramRun honest = run_cps(verify);
  INFO(honest.output);
  CHECK(honest.exit_status == 0);
  for (const auto& leaf : fs::directory_iterator(out / "240x180_unified_spherical_hfov150")) {
    const fs::path file = leaf.path() / "calibration.json";
    nlohmann::ordered_json label = nlohmann::ordered_json::parse(read_file(file));
    label["K"][0][0] = 1.03 * label["K"][0][0].get<double>();
    label["K"][1][1] = label["K"][0][0];
    write_json(file, label);
  }
  const ProgramRun altered = run_cps(verify);
  INFO(altered.output);
  CHECK(altered.exit_status == 1);
  CHECK_THAT(altered.output, Catch::Contains("off what its label and pose say") &&
                                 Catch::Contains("is not what the recipe gives"));
}

TEST_CASE(
    "a recipe that mixes another lens family with keys of Brown-Conrady lenses is refused by their names") {
  const TemporaryFolder temporary;
  const std::string start =
      "generate --scene a.glb --size 80x45 --views 3 --lenses 1 --lens_model eucm --out " +
      (temporary.path / "x").string();
  check_refused(start + " --base_hfov_deg 90", 1, "base_hfov_deg: is an H-FOV before a crop");
  check_refused(start + " --hfov_deg 90 --lens_draw shape_prior", 1,
                "lens_draw: is for brown_conrady lenses");
  check_refused(start + " --hfov_deg 90 --keep_masters true", 1, "keep_masters: must be false");
}
