#include <catch2/catch.hpp>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("names with blanks and letters of any script work in every option that takes one") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path / "Straße 3 Straßenköter 道路 é";
  fs::create_directories(folder);
  const fs::path scene = write_street_gltf(folder), out = folder / "data set ü";

  // Scenes and the dataset's folder; rig, recipe, route and look.
  write_file(folder / "mein rig ö.rig", read_file(std::string(CPS_RECIPES) + "/single.rig"));
  write_file(
      folder / "mein Rezept 食.cfg",
      "name = t\nscene = " + scene.string() +
          "\nsize = 80x45\nbase_hfov_deg = 60\nviews = 4\nlenses = 1\nsamples = 2\nrig = mein rig ö.rig\n"
          "split = thesis\n");
  write_file(folder / "Weg å.csv", std::string("x,y,z\n-100,0,-60\n100,0,-60\n"));
  const std::string generate = "generate --recipe " + quoted(folder / "mein Rezept 食.cfg") + " --route " +
                               quoted(folder / "Weg å.csv") + " --look " + quoted(folder / "Blick ñ") +
                               " -o " + quoted(out);
  require_success(generate);
  CHECK_THAT(require_success(generate), Catch::Contains("nothing to do"));
  CHECK(fs::exists(folder / "Blick ñ" / "street.png"));
  require_success("verify --rerender 1 " + quoted(out));
  require_success("contact-sheet " + quoted(out) + " -o " + quoted(folder / "Bogen ß.png"));
  CHECK(fs::exists(folder / "Bogen ß.png"));

  // Renders.
  require_success("render " + quoted(scene) + " -o " + quoted(folder / "Bild æ.png") +
                  " --size 40x30 --samples 1");
  CHECK(fs::exists(folder / "Bild æ.png"));

  // Lenses and pictures: one, and a folder of them.
  const fs::path lens = folder / "Objektiv ç.yml", pictures = folder / "Bilder ş";
  fs::rename(write_barrel(folder), lens);
  for (const char* name : {"eins zwei.png", "drei 三.png"})
    write_image(pictures / name, 160, 100, 3, OIIO::TypeUInt8,
                [](int x, int y, int c) { return noise(x, y, c); });
  require_success("lens check " + quoted(lens));
  require_success("undistort " + quoted(pictures / "drei 三.png") + " --lens " + quoted(lens) + " -o " +
                  quoted(folder / "gerade ü.png"));
  CHECK(fs::exists(folder / "gerade ü.png"));
  require_success("undistort " + quoted(pictures) + " --lens " + quoted(lens) + " -o " +
                  quoted(folder / "gerade ö"));
  for (const char* name : {"eins zwei.png", "drei 三.png"}) CHECK(fs::exists(folder / "gerade ö" / name));
}
