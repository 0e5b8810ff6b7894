#include <catch2/catch.hpp>

#include "dataset/exchange/calibration_file.h"
#include "files/files.h"
#include "tests/apps/cps_program.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

void check_refused_by_trainer(const std::string& arguments, int status, const std::string& line) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments);
  CHECK(run.exit_status == status);
  CHECK(run.output == "cps-train: " + line + "\n");
}

}  // namespace

TEST_CASE("options that do not go with one camera are refused as wrong usage") {
  const std::string predict = "predict --model m a.png ";
  check_refused_by_trainer(predict + "--common-share .5", 2, "--common-share: belongs to --one-camera");
  check_refused_by_trainer(predict + "--one-camera --common-share 1.5", 2,
                           "--common-share: must lie in [0, 1]");
  check_refused_by_trainer(
      predict + "--one-camera --variants 4", 2,
      "--variants: not with --one-camera, whose deviations take the place of the spread");
  check_refused_by_trainer(predict + "--one-camera --undistort out", 2,
                           "--undistort: not with --one-camera: give cps undistort --lens the calibration "
                           "that --cameras writes");
  check_refused_by_trainer(predict + "--cameras out --format tum", 2,
                           "format: 'tum' is none of cps, opencv-yaml, opencv-xml, colmap, ros, kitti, "
                           "kalibr, nerfstudio, all");
  check_refused_by_trainer("predict --model none --one-camera a.png", 1,
                           "none/model.json: is missing: name a folder that cps train has written");
}

TEST_CASE("a camera's frames make one calibration in every format", "[slow]") {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path.string(), data = folder + "/data", out = folder + "/out";
  require_success("city --seed 1 --extent-m 300 -o " + folder + "/city.glb");
  require_success(tiny_recipe(folder + "/city.glb", data));
  const std::string train = "train --data " + data + " --width 32 --batch 4 --epochs 1 --out " + folder;
  require_success(train + "/fit --arch resnet18-16 --head fit");
  require_success(train + "/direct --arch resnet18-16");

  // A leaf folder also holds labels of pixels, which are no pictures.
  fs::path leaf;
  for (const auto& entry : fs::recursive_directory_iterator(data))
    if (entry.path().filename() == "calibration.json") leaf = entry.path().parent_path();
  const std::string one_camera = " --one-camera " + leaf.string();
  const std::string said = require_success("predict --model " + folder + "/fit" + one_camera + " --cameras " +
                                           out + " --format all");
  CHECK_THAT(said, Catch::Contains("pictures agree") &&
                       Catch::Contains("left out: " + out + "/camchain.yaml") &&
                       Catch::Contains(out + "/one_camera.json"));
  const nlohmann::json json = read_json(out + "/one_camera.json");
  CHECK(json.at("truth").contains("k1"));
  CHECK_THAT(read_file(out + "/one_camera.svg"), Catch::StartsWith("<svg"));
  for (CalibrationFormat format : calibration_formats()) {
    const fs::path file = fs::path(out) / usual_file_name(format);
    INFO(file);
    CHECK(fs::exists(file) == (format != CalibrationFormat::kalibr));  // which has no place for k3
    if (!fs::exists(file)) continue;
    const CalibratedCamera camera = read_calibration(file).at(0);
    CHECK(camera.distortion.k1 ==
          Approx(json.at("certified").at("calibration").at("k1").get<double>()).epsilon(1e-9));
  }

  const std::string needs_fit = "needs a model that was trained with --head fit";
  check_refused_by_trainer("predict --model " + folder + "/direct" + one_camera, 2,
                           "--one-camera: " + needs_fit);
  check_refused_by_trainer("eval --model " + folder + "/direct --data " + data + " --per-camera", 2,
                           "--per-camera: " + needs_fit);
  CHECK_THAT(require_success("eval --model " + folder + "/fit --data " + data + " --per-camera"),
             Catch::Contains("one camera from all its"));
}
