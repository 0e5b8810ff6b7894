#include <catch2/catch.hpp>
#include <sstream>

#include "tests/apps/cps_program.h"
#include "tests/apps/street_gltf.h"
#include "tests/files_in.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("wrong usage exits 2 with one line") {
  check_refused("fly", 2, "'fly' is not a verb");
  for (const char* verb : {"city", "render", "plan", "generate", "finish", "verify", "contact-sheet",
                           "export", "lens", "distort", "undistort"})
    check_refused(std::string(verb) + " --no-such-flag 3", 2, "no-such-flag");
  check_refused("verify", 2, "dataset");
  check_refused("generate --out", 2, "out");
  check_refused("city --style village -o a.glb", 2, "--style village: ");
  check_refused("city --traffic 3 -o a.glb", 2, "--traffic: must lie in [0, 2]");
  check_refused("city --extent-m 9 -o a.glb", 2, "--extent_m: must lie in [300, 1200]");
  check_refused("city --seed 1", 2, "--out");
}

TEST_CASE("--threads means the same in every verb: 0 for all cores, nothing below") {
  const TemporaryFolder temporary;
  const std::string out = (temporary.path / "out").string();
  for (const std::string& verb :
       {"generate --out " + out, "plan --out " + out, "render scene.glb -o " + out + ".png",
        "distort a.png -o " + out + " --hfov 60 --lens l.json",
        "undistort a.png -o " + out + " --lens l.json", "relens --kitti k -o " + out}) {
    check_refused(verb + " --threads -1", 2, "--threads -1: must lie in [0, 4096]");
    check_refused(verb + " --threads 1.5", 2, "threads");
    CHECK_THAT(run_cps(verb + " --threads 0").output, !Catch::Contains("threads"));
  }
}

TEST_CASE("help is printed for every verb and exits 0") {
  CHECK(run_cps("help").exit_status == 0);
  for (const char* verb : {"city", "render", "plan", "generate", "finish", "verify", "contact-sheet",
                           "export", "lens", "distort", "undistort"}) {
    const ProgramRun run = run_cps("help " + std::string(verb));
    CHECK(run.exit_status == 0);
    CHECK_THAT(run.output, Catch::Contains("cps " + std::string(verb)));
  }
}

TEST_CASE("a bad recipe is refused before any work, in one line with key and range") {
  const TemporaryFolder temporary;
  const fs::path recipe = temporary.path / "bad.cfg", out = temporary.path / "out";
  const std::string good = "city_seed = 1\nsize = 80x45\nbase_hfov_deg = 60\nviews = 3\nlenses = 1\n";
  const std::pair<const char*, const char*> cases[] = {
      {"viwes = 3", "viwes"},
      {"base_hfov_deg = 0", "base_hfov_deg, hfov_deg: must lie in [5, 165]"},
      {"base_hfov_deg = 180", "base_hfov_deg, hfov_deg: must lie in [5, 165]"},
      {"scene = a/city.glb, b/city.glb", "scene: two files in different folders have the same name"},
      {"views = 0", "views: must lie in [3, 1000000]"},
      {"views = 3, 4", "views: name one number, or as many as there are sizes"},
      {"size = -80x45", "size: width and height must be at least 32 pixels"},
      {"size = 80x0", "size: width and height must be at least 32 pixels"},
      {"min_eigenvalue = 2", "min_eigenvalue"},
      {"max_displacement = 0", "max_displacement: must lie between 0 and 1"},
      {"lens_draw = shape_prior\nsequential_share = 0\nmax_displacement = 1e-6",
       "60 degrees: no lens within"},
      {"k1_min = 0.1", "k1_min ≤ 0 ≤ k1_max"},
      {"rig = nowhere.rig", "nowhere.rig"},
      {"scale = -1", "scale: must be above 0 and at most 100"},
      {"scene = /nonexistent.glb", "/nonexistent.glb: there is no such file"}};
  for (const auto& [lines, expected] : cases) {
    const std::string bad = lines, key = bad.substr(0, bad.find(" ="));
    std::string text = bad + "\n";
    std::istringstream rest(good);
    for (std::string line; std::getline(rest, line);)
      if (!line.starts_with(key + " ")) text += line + "\n";
    write_file(recipe, text);
    for (const char* verb : {"generate", "plan"})
      check_refused(std::string(verb) + " --recipe " + recipe.string() + " --out " + out.string(), 1,
                    expected);
    CHECK(!fs::exists(out));
  }
}

TEST_CASE("file names may have spaces and any letters, from the options to the job that verify reads") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path / "mein Ordner ä";
  fs::create_directories(folder);
  const fs::path scene = write_street_gltf(folder);
  for (const char* name : {"a b.png", "straße 2.exr"}) {
    const ProgramRun run =
        run_cps("render " + quoted(scene) + " --size 16x16 --samples 1 --output " + quoted(folder / name));
    INFO(run.output);
    CHECK(run.exit_status == 0);
    CHECK(fs::exists(folder / name));
  }
  const ProgramRun made = run_cps("generate --scene " + quoted(scene) +
                                  " --size 80x45 --base-hfov-deg=60 --views 3"
                                  " --samples 2 -o " +
                                  quoted(folder / "data set"));
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  const ProgramRun verified = run_cps("verify " + quoted(folder / "data set"));
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  CHECK_THAT(verified.output, !Catch::Contains("not planned again"));
}

TEST_CASE("missing, broken and unwritable things exit 1 with one line and leave no file") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "out";
  fs::create_directories(out);
  const std::string o = out.string();
  const std::string rest = " --size 80x45 --base_hfov_deg 60 --views 3 --samples 2 --out " + o + "/dataset";
  check_refused("generate --city_seed 1 --city_style village" + rest, 1, "european, downtown");
  check_refused("render /nonexistent.glb -o " + o + "/a.png", 1, "/nonexistent.glb");
  check_refused("generate --recipe /nonexistent.cfg --out " + o + "/dataset", 1, "/nonexistent.cfg");
  check_refused("generate --scene /nonexistent.glb" + rest, 1, "/nonexistent.glb");

  check_refused("generate --scene " + scene.string() + " --size 80x45 --base_hfov_deg 179 --views 3 --out " +
                    o + "/dataset",
                1, "base_hfov_deg");
  check_refused("generate --scene " + scene.string() + " --size 0x45 --base_hfov_deg 60 --views 3 --out " +
                    o + "/dataset",
                1, "size");
  check_refused("verify /nonexistent", 1, "/nonexistent");
  check_refused("contact-sheet /nonexistent -o " + o + "/a.png", 1, "/nonexistent");

  write_file(folder / "truncated.glb", std::string("glTF\x02\0\0\0\xff\xff\0\0", 12));
  check_refused("render " + (folder / "truncated.glb").string() + " -o " + o + "/a.png", 1, "truncated.glb");
  write_file(folder / "garbage.gltf", std::string("{ \"asset\": "));
  check_refused("render " + (folder / "garbage.gltf").string() + " -o " + o + "/a.png", 1, "garbage.gltf");
  CHECK(files_in(out) == 0);

  write_file(folder / "file", std::string("in the way"));
  const std::string blocked = (folder / "file" / "a.png").string();
  check_refused("render " + scene.string() + " --size 16x16 --samples 1 -o " + blocked, 1, "a.png");
  check_refused("city --seed 1 -o " + (folder / "file" / "city.glb").string(), 1, "city.glb");
  check_refused("generate --scene " + scene.string() + " --size 80x45 --base_hfov_deg 60 --views 3 --out " +
                    (folder / "file" / "dataset").string(),
                1, "dataset");
}
