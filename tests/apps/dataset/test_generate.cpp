#include <OpenImageIO/imagebuf.h>

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("generate, verify and contact-sheet make a whole dataset, and a finished one is left alone") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  const ProgramRun made = run_cps(tiny_recipe(scene, out));
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  const auto files = contents(out);
  std::map<std::string, int> count;  // by what follows the image's number
  for (const auto& [name, bytes] : files) ++count[name.substr(std::min(name.find('.'), name.size()))];
  for (const char* ending : {".png", ".depth.exr", ".instance.png", ".semantic.png", ".up.exr"})
    CHECK(count[ending] == 2 * 5 * 3);
  CHECK(files.contains("80x45_hfov060/front_lens0000/calibration.json"));
  CHECK(files.at("dataset.json").find("made by a test") != std::string::npos);
  const ProgramRun verified = run_cps("verify " + out.string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  CHECK_THAT(verified.output, Catch::Contains("30 images, 120 dense labels, 0 faults"));
  CHECK(run_cps("contact-sheet " + out.string() + " -o " + (folder / "sheet.png").string()).exit_status == 0);
  const auto before = fs::last_write_time(out / "dataset.json");
  const ProgramRun again = run_cps(tiny_recipe(scene, out));
  CHECK(again.exit_status == 0);
  CHECK_THAT(again.output, Catch::Contains("nothing to do"));
  CHECK(fs::last_write_time(out / "dataset.json") == before);
}

TEST_CASE("label-first, the images have the H-FOV asked for and their bases differ") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  const ProgramRun made = run_cps("generate --scene " + scene.string() +
                                  " --size 80x45 --hfov_deg 70 --views 3 --lenses 3 --samples 2 "
                                  "--lens_draw shape_prior --out " +
                                  out.string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  std::set<double> bases;
  for (const auto& entry : fs::directory_iterator(out / "80x45_hfov070")) {
    const nlohmann::json label = read_json(entry.path() / "calibration.json");
    CHECK(label["fov"].get<double>() == Approx(70).epsilon(1e-9));
    bases.insert(label["fov_base_deg"].get<double>());
  }
  CHECK(bases.size() == 10);  // the undistorted lens and three for each of three parts
  CHECK(*bases.begin() == Approx(70));
  CHECK(*bases.rbegin() > 75);
  const ProgramRun verified = run_cps("verify " + out.string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
}

TEST_CASE("a rig's cameras have folders, labels and lenses of their own and share their places") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  const ProgramRun made = run_cps("generate --scene " + scene.string() +
                                  " --size 80x45 --base_hfov_deg 70 --views 3 --lenses 1 --samples 2 --rig " +
                                  CPS_RECIPES + "/kitti.rig --out " + out.string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  CHECK_THAT(made.output, Catch::Contains("12 views, 16 groups, 24 images; ") && Catch::Contains("% of ") &&
                              Catch::Contains("places rejected"));
  const nlohmann::json label = read_json(out / "80x45_hfov070/cam1_lens0000/calibration.json");
  CHECK(label["camera"]["name"] == "cam1");
  CHECK(label["camera"]["T_vehicle_camera"][1][3].get<double>() == Approx(-0.5371));
  const nlohmann::json description = read_json(out / "dataset.json");
  CHECK(description["rig"].size() == 4);
  CHECK(description["rig"][1]["T_vehicle_camera"] == label["camera"]["T_vehicle_camera"]);
  CHECK(description["places"]["rejected_for"].contains("too_close"));
  const auto vehicle_of =
      [&](const std::string& camera) {  // file, part, condition, street and pose, a line each
        std::istringstream lines(read_file(out / "80x45_hfov070" / (camera + "_lens0000") / "frames.csv"));
        std::string vehicles;
        for (std::string line; std::getline(lines, line);) {
          std::size_t end = 0;
          for (int field = 0; field < 10; ++field) end = line.find(',', end) + 1;
          vehicles += line.substr(0, end) + "\n";
        }
        return vehicles;
      };
  CHECK(vehicle_of("cam0") == vehicle_of("cam3"));
  const ProgramRun verified = run_cps("verify " + out.string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  check_refused(tiny_recipe(scene, folder / "none") + " --rig none.rig", 1, "rig = none.rig");
}

TEST_CASE("one thread and three make the same bytes") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "one") + " --threads 1").exit_status == 0);
  REQUIRE(run_cps(tiny_recipe(scene, folder / "three") + " --threads 3").exit_status == 0);
  CHECK(contents(folder / "one") == contents(folder / "three"));
}

TEST_CASE("verify says which frames.csv has no header, and ends") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  REQUIRE(run_cps(tiny_recipe(scene, out)).exit_status == 0);
  const fs::path csv = out / "80x45_hfov060" / "front_lens0000" / "frames.csv";
  for (const auto& [text, missing] : {std::pair("", "file"), std::pair("file,part\n", "condition")}) {
    write_file(csv, std::string(text));
    const ProgramRun run = run_cps("verify " + out.string());
    INFO(run.output);
    CHECK(run.exit_status == 1);
    CHECK_THAT(run.output, Catch::Contains("80x45_hfov060/front_lens0000/frames.csv: " +
                                           std::string(missing) + ": column is missing"));
  }
}

TEST_CASE("a folder begun with another recipe is refused") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  REQUIRE(run_cps(tiny_recipe(scene, out)).exit_status == 0);
  const ProgramRun refused = run_cps(tiny_recipe(scene, out) + " --max_zoom 2");
  CHECK(refused.exit_status == 1);
  CHECK_THAT(refused.output, Catch::Contains("max_zoom = 2"));
}

TEST_CASE("a drive from a file belongs to one scene, not to drawn cities as well") {
  const TemporaryFolder folder;
  for (const char* cities : {"--cities 1", "--city_seed 4"}) {
    const ProgramRun run =
        run_cps("generate --scene a.glb --size 80x45 --base_hfov_deg 60 --views 3 --route r.csv " +
                std::string(cities) + " --out " + (folder.path / "d").string());
    INFO(run.output);
    CHECK(run.exit_status == 2);
    CHECK_THAT(run.output, Catch::Contains("--route: needs a recipe with one scene and no city"));
  }
}

TEST_CASE("every image format verifies, and has the same bytes from one thread and three") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  const std::pair<const char*, const char*> formats[] = {
      {"png_gray", ".png"}, {"jpeg", ".jpg"}, {"exr", ".exr"}};
  for (const auto& [format, extension] : formats) {
    INFO(format);
    const fs::path one = folder / (std::string(format) + "1"), three = folder / (std::string(format) + "3");
    const std::string key = " --image_format " + std::string(format);
    REQUIRE(run_cps(tiny_recipe(scene, one) + key + " --threads 1").exit_status == 0);
    REQUIRE(run_cps(tiny_recipe(scene, three) + key + " --threads 3").exit_status == 0);
    CHECK(differences(one, three) == "");
    CHECK(fs::exists(one / "80x45_hfov060" / "front_lens0000" / ("000000" + std::string(extension))));
    const ProgramRun verified = run_cps("verify " + one.string());
    INFO(verified.output);
    CHECK(verified.exit_status == 0);
    CHECK_THAT(verified.output, Catch::Contains("30 images, 120 dense labels, 0 faults"));
    CHECK(run_cps("contact-sheet " + one.string() + " -o " + (folder / "sheet.png").string()).exit_status ==
          0);
  }
}

TEST_CASE("what the importer leaves out is said once on stderr and kept in dataset.json, with the origin") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  nlohmann::ordered_json gltf = read_json(scene);
  gltf["materials"][0]["extensions"]["KHR_materials_sheen"] = nlohmann::ordered_json::object();
  gltf["extensionsUsed"] = {"KHR_materials_sheen"};
  const double east_m = 456'000, south_m = -5'430'000;
  gltf["nodes"].push_back(
      {{"translation", {east_m, 112, south_m}}, {"children", gltf["scenes"][0]["nodes"]}});
  gltf["scenes"][0]["nodes"] = {gltf["nodes"].size() - 1};
  for (auto& lane : gltf["scenes"][0]["extras"]["cps_lanes"])
    for (auto& point : lane["points"]) {
      point[0] = point[0].get<double>() + east_m;
      point[1] = 112;
      point[2] = point[2].get<double>() + south_m;
    }
  write_json(scene, gltf);

  const std::string streams = (folder / "stdout").string() + " 2>" + (folder / "stderr").string();
  const int status = std::system((CPS_PROGRAM " " + tiny_recipe(scene, out) + " >" + streams).c_str());
  const std::string said = read_file(folder / "stderr");
  INFO(said);
  REQUIRE(status == 0);
  const auto at = said.find("KHR_materials_sheen");
  REQUIRE(at != said.npos);
  CHECK(said.find("KHR_materials_sheen", at + 1) == said.npos);
  CHECK_THAT(said, Catch::Contains("street.gltf: warning: "));
  CHECK_THAT(read_file(folder / "stdout"), !Catch::Contains("KHR_materials_sheen"));
  const nlohmann::json entry = read_json(out / "dataset.json")["scenes"][0];
  REQUIRE(entry["import_warnings"].size() == 1);
  CHECK_THAT(entry["import_warnings"][0].get<std::string>(), Catch::Contains("KHR_materials_sheen"));
  CHECK(entry["origin_m"][0].get<double>() == Approx(east_m).margin(500));
  CHECK(entry["origin_m"][2].get<double>() == Approx(south_m).margin(500));
}

TEST_CASE("a scene that no light reaches has no places, and the message says why") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  nlohmann::ordered_json gltf = read_json(scene);
  // Every street becomes a closed tunnel, 8 m wide and 5 m high.
  for (int street = 0; street < 6; ++street) {
    const double z = -60 + 24 * street;
    for (const auto& [x, y, dz, sx, sy, sz] : {std::tuple{0, 5, 0, 320, 1, 10},
                                               {0, 0, -5, 320, 6, 1},
                                               {0, 0, 5, 320, 6, 1},
                                               {-158, 0, 0, 1, 6, 10},
                                               {158, 0, 0, 1, 6, 10}}) {
      gltf["nodes"].push_back({{"mesh", 1}, {"translation", {x, y, z + dz}}, {"scale", {sx, sy, sz}}});
      gltf["scenes"][0]["nodes"].push_back(gltf["nodes"].size() - 1);
    }
  }
  write_json(scene, gltf);
  check_refused(tiny_recipe(scene, folder / "dataset") + " --clearance_m 1", 1, "200 dark");
}

TEST_CASE("a scene without lanes says where cars drive, and why there") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  nlohmann::ordered_json gltf = read_json(scene);
  gltf["scenes"][0].erase("extras");
  write_json(scene, gltf);
  const ProgramRun made = run_cps(tiny_recipe(scene, folder / "dataset") + " --split thesis");
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  int drives = 0;
  double metres = 0, level_m = -1, percent = 0;
  const std::string line = made.output.substr(made.output.find("street.gltf: "));
  REQUIRE(std::sscanf(line.c_str(),
                      "street.gltf: 1 m per unit, %d drives found, %lf m on ground at y = %lf m with things "
                      "in %lf %% of all directions",
                      &drives, &metres, &level_m, &percent) == 4);
  CHECK(drives >= 3);
  CHECK(metres >= 4 * drives);  // the shortest that is taken
  CHECK(level_m == 0);          // the street, not the roofs
  CHECK(percent > 20);          // of a lawn it would be less
}

TEST_CASE("--look shows the scene from above") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  const std::string recipe = "generate --scene " + scene.string() +
                             " --size 80x45 --base_hfov_deg 60 --views 3 --lenses 1 --samples 2 --out ";
  const ProgramRun made =
      run_cps(recipe + (folder / "dataset").string() + " --look " + (folder / "look").string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  const OIIO::ImageBuf picture((folder / "look" / "street.png").string());
  REQUIRE_FALSE(picture.has_error());
  CHECK(picture.spec().width == 800);
  // A folder cannot have the name of a file.
  check_refused(recipe + (folder / "second").string() + " --look " + scene.string(), 1, scene.string());
}
