#include <catch2/catch.hpp>

#include "tests/apps/dataset/dataset_runs.h"
#include "tests/apps/street_gltf.h"
#include "tests/dataset/edit_csv.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Changes a number in every label of a set that has a lens.
void change_labels(const fs::path& set, const std::string& key, double by) {
  for (const auto& leaf : fs::directory_iterator(set)) {
    const fs::path file = leaf.path() / "calibration.json";
    nlohmann::ordered_json label = nlohmann::ordered_json::parse(read_file(file));
    label[key] = label[key].get<double>() + by;
    if (key == "cx") label["K"][0][2] = label[key];
    write_json(file, label);
  }
}

/// Turns every camera of a set about the vertical: its quaternion q becomes (cos a/2, 0, sin a/2, 0) q.
void turn_cameras(const fs::path& set, double angle_rad) {
  for (const auto& leaf : fs::directory_iterator(set)) {
    const fs::path file = leaf.path() / "frames.csv";
    CsvTable table = read_csv(file);
    const double c = std::cos(angle_rad / 2), s = std::sin(angle_rad / 2);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const auto field = [&](const char* name) -> std::string& { return table.rows[r][table.column(name)]; };
      const double w = std::stod(field("camera_qw")), x = std::stod(field("camera_qx")),
                   y = std::stod(field("camera_qy")), z = std::stod(field("camera_qz"));
      field("camera_qw") = fmt::format("{}", c * w - s * y);
      field("camera_qx") = fmt::format("{}", c * x + s * z);
      field("camera_qy") = fmt::format("{}", c * y + s * w);
      field("camera_qz") = fmt::format("{}", c * z - s * x);
    }
    write_csv(table);
  }
}

}  // namespace

TEST_CASE("images rendered again through their labels' lenses agree; a label that was altered is found") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder), out = folder / "dataset";
  const ProgramRun made = run_cps("generate --seed 3 --scene " + scene.string() +
                                  " --size 320x180 --base_hfov_deg 90 --views 3 --lenses 1 --samples 16 "
                                  "--lens_draw shape_prior --out " +
                                  out.string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);
  const std::string verify = "verify " + out.string() + " --rerender 6 --samples 64";
  const ProgramRun honest = run_cps(verify);
  INFO(honest.output);
  CHECK(honest.exit_status == 0);
  const nlohmann::json report = read_json(out / ".cps" / "rerender.json");
  REQUIRE(report["images"].size() == 6);
  for (const auto& image : report["images"]) {
    CHECK(image["blocks"].get<int>() > 3);
    CHECK(image["block_rms_px"].get<double>() < 0.2);
    CHECK(image["psnr_db"].get<double>() > 20);
    CHECK(image["correlation"].get<double>() > 0.8);
  }
  const auto check_found = [&](const char* what) {
    const ProgramRun run = run_cps(verify);
    INFO(run.output);
    CHECK(run.exit_status == 1);
    CHECK_THAT(run.output, Catch::Contains(what) && Catch::Contains("is not what the recipe gives"));
  };
  change_labels(out / "320x180_hfov090", "cx", 0.5);
  check_found("px off what its label and pose say");
  change_labels(out / "320x180_hfov090", "cx", -0.5);
  change_labels(out / "320x180_hfov090", "k1", 0.01);
  check_found("px (rms) off what its label and pose say");
  change_labels(out / "320x180_hfov090", "k1", -0.01);

  // Poses are taken from frames.csv: a turn by half a pixel, a step to the side, another view.
  const auto check_pose_found = [&](const char* what, const char* column) {
    const ProgramRun plain = run_cps("verify " + out.string());
    INFO(plain.output);
    CHECK(plain.exit_status == 1);
    CHECK_THAT(plain.output, Catch::Contains("frames.csv: 000000.png: ") && Catch::Contains(column) &&
                                 Catch::Contains("is not what the recipe gives"));
    check_found(what);
  };
  turn_cameras(out / "320x180_hfov090", 0.5 / 160);
  check_pose_found("px off what its label and pose say", "camera_qw");
  turn_cameras(out / "320x180_hfov090", 0.5);
  check_pose_found("shows another view than its label and pose say", "camera_qw");
  turn_cameras(out / "320x180_hfov090", -0.5 - 0.5 / 160);
  for (const auto& leaf : fs::directory_iterator(out / "320x180_hfov090"))
    add_to_column(leaf.path() / "frames.csv", "camera_y_m", 0.1);
  check_pose_found("off what its label and pose say", "camera_y_m");
}
