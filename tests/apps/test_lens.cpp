#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "dataset/exchange/calibration_file.h"
#include "distortion/pinhole.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "tests/apps/cps_program.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// calib_cam_to_cam.txt of KITTI, 2011-09-26 (Geiger et al. 2013): S, K and D of cameras 00 and 03.
const std::vector<CalibratedCamera> kitti{
    {"00",
     {1392, 512, 984.2439, 980.8141, 690.0, 233.1966},
     {-0.3728755, 0.2037299, -0.07233722, 0.002219027, 0.001383707}},
    {"03",
     {1392, 512, 903.7596, 901.9653, 695.7519, 224.2509},
     {-0.3639558, 0.1788651, -0.05382460, 0.0006029694, -0.0003922424}}};

std::vector<std::vector<double>> csv_rows(const std::string& text) {
  std::istringstream lines(text);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace

TEST_CASE("lens limits of k1 and p1 are the closed forms, at every H-FOV and size") {
  const ProgramRun run = run_cps(
      "lens limits --size 1920x1080,1392x512 --hfov 30,90,150 --csv --min_eigenvalue 0.2 --max_eigenvalue "
      "1.5 "
      "--max_tangential 0.01");
  REQUIRE(run.exit_status == 0);
  const auto rows = csv_rows(run.output);
  REQUIRE(rows.size() == 6);
  for (const std::vector<double>& row : rows) {
    REQUIRE(row.size() == 13);
    const double half_diagonal = std::tan(radians(row[2]) / 2) * std::hypot(1, row[1] / row[0]);
    // On the corner 1 + 3 k1 r² is the smallest eigenvalue of a barrel, the largest of a pincushion.
    CHECK(row[3] == Approx(-0.8 / 3 / (half_diagonal * half_diagonal)).epsilon(1e-3));
    CHECK(row[4] == Approx(0.5 / 3 / (half_diagonal * half_diagonal)).epsilon(1e-3));
    CHECK(row[10] == Approx(0.01 / half_diagonal).epsilon(1e-3));
    CHECK(row[9] == Approx(-row[10]));
  }
}

TEST_CASE("lens limits draws its plot, and refuses what cannot be") {
  const TemporaryFolder folder;
  const fs::path plot = folder.path / "limits.svg";
  const ProgramRun run = run_cps("lens limits --size 640x480 --hfov 60 -o " + plot.string());
  CHECK(run.exit_status == 0);
  CHECK_THAT(run.output, Catch::Contains("640x480") && Catch::Contains("k3"));
  CHECK_THAT(read_file(plot), Catch::StartsWith("<svg") && Catch::Contains("Limits of p2"));
  check_refused("lens limits --size 640", 2, "--size 640");
  check_refused("lens limits --hfov 180", 2, "--hfov");
  check_refused("lens limits --min_eigenvalue 2", 2, "min_eigenvalue");
  check_refused("lens limits --max_eigenvalue x", 2, "max_eigenvalue = x");
  check_refused("lens limits --size 64x48 --hfov 60 -o " + (plot / "a.svg").string(), 1, "a.svg");
  check_refused("lens", 2, "limits, check, convert or sample");
  check_refused("lens fly", 2, "'fly'");
  for (const char* verb : {"limits", "check", "convert", "sample"})
    CHECK_THAT(run_cps("help lens " + std::string(verb)).output,
               Catch::StartsWith("cps lens " + std::string(verb)));
}

TEST_CASE("lens check proves KITTI's camera 00 and refuses 03, whose corners lie beyond its polynomial") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "calib_cam_to_cam.txt";
  write_calibration(file, CalibrationFormat::kitti, kitti);
  const ProgramRun good = run_cps("lens check --camera 00 " + file.string());
  INFO(good.output);
  CHECK(good.exit_status == 0);
  CHECK_THAT(good.output, Catch::Contains("yes, proved") && Catch::Contains("label 70.53") &&
                              Catch::Contains("seen 83.11") && Catch::Contains("712704 pixels"));
  const ProgramRun both = run_cps("lens check " + file.string());
  INFO(both.output);
  CHECK(both.exit_status == 1);
  CHECK_THAT(both.output, Catch::Contains("camera 00: 1392") && Catch::Contains("camera 03: 1392") &&
                              Catch::Contains("no: proved for 7126") &&
                              Catch::Contains("cps: " + file.string() + ": camera 03: the lens cannot be"));
  check_refused("lens check --camera 07 " + file.string(), 1, "'07' is none of 00 03");
}

TEST_CASE("lens check names where other programs' inverses go wrong") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "pincushion.yml";
  write_calibration(
      file, CalibrationFormat::opencv_yaml,
      std::vector<CalibratedCamera>{{"", {640, 400, 260, 260, 325, 190}, {.k1 = 0.35, .k2 = 0.05}}});
  const ProgramRun run = run_cps("lens check " + file.string());
  INFO(run.output);
  CHECK(run.exit_status == 0);
  CHECK_THAT(run.output,
             Catch::Contains("ratio, 5 steps (OpenCV)  ") && Catch::Contains("px off the principal point"));
  CHECK_THAT(run.output, Catch::Contains("none: the radial part grows for ever"));
}

TEST_CASE("lens check refuses what no lens is, in one line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& numbers, const std::string& expected) {
    const fs::path file = folder.path / "cameras.txt";
    write_file(file, "1 FULL_OPENCV " + numbers + "\n");
    check_refused("lens check " + file.string(), 1, expected);
  };
  refused("640 480 0 500 320 240 0 0 0 0 0 0 0 0", "fx, fy");
  refused("640 480 500 500 900 240 0 0 0 0 0 0 0 0", "principal point");
  refused("640 480 500 500 320 240 nan 0 0 0 0 0 0 0", "finite");
  refused("640 900000 500 500 320 240 0 0 0 0 0 0 0 0", "width, height");
  check_refused("lens check /nonexistent.yml", 1, "/nonexistent.yml");
  check_refused("lens check", 2, "file");
  write_file(folder.path / "cameras.txt", std::string("1 OPENCV 640 480 320 320 320 240 -0.5 0 0 0\n"));
  const ProgramRun folds = run_cps("lens check " + (folder.path / "cameras.txt").string());
  CHECK(folds.exit_status == 1);
  CHECK_THAT(folds.output, Catch::Contains("folds") && Catch::Contains("dominant term k1") &&
                               Catch::Contains("would pass"));
}

TEST_CASE("lens sample lists the lenses that a recipe would draw") {
  const TemporaryFolder folder;
  const std::string common = "lens sample 20 --size 640x360 --hfov 80 --seed 5 --lens_draw shape_prior ";
  const ProgramRun csv = run_cps(common);
  REQUIRE(csv.exit_status == 0);
  CHECK(run_cps(common).output == csv.output);
  CHECK(run_cps("lens sample 20 --size 640x360 --hfov 80 --seed 6 --lens_draw shape_prior").output !=
        csv.output);
  const auto rows = csv_rows(csv.output);
  REQUIRE(rows.size() == 20);
  const fs::path plot = folder.path / "plot.svg";
  const nlohmann::json json = nlohmann::json::parse(run_cps(common + "--json -o " + plot.string()).output);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(json[i]["k1"].get<double>() == rows[i][1]);
    const double zoom = json[i]["zoom"], fov = radians(json[i]["fov"]);
    CHECK(zoom * std::tan(fov / 2) == Approx(std::tan(radians(80) / 2)));
    CHECK(json[i]["min_eigenvalue"].get<double>() >= 0.15);
  }
  CHECK_THAT(read_file(plot), Catch::Contains("k2 against k1"));
  // Label-first, every image has the H-FOV asked for, and bases differ.
  const auto label_first = nlohmann::json::parse(run_cps(common + "--label-first --json").output);
  std::set<double> bases;
  for (const auto& lens : label_first) {
    CHECK(lens.at("fov").get<double>() == Approx(80).epsilon(1e-6));
    CHECK(lens.at("fov_base_deg").get<double>() > 80 - 1e-6);
    bases.insert(lens.at("fov_base_deg").get<double>());
  }
  CHECK(bases.size() > 15);  // a lens that needs no crop has the base of the image
  check_refused("lens sample 0 --size 640x360 --hfov 80", 2, "between 1 and");
  check_refused("lens sample 5 --hfov 80", 2, "size");
  check_refused("lens sample 5 --size 640x360 --hfov 80 --lens_draw guess", 2, "sequential, shape_prior");
}
