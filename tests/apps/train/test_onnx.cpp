#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/apps/cps_program.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

void check_trainer_refuses(const std::string& arguments, int status, const std::string& line) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments);
  CHECK(run.exit_status == status);
  CHECK(run.output == "cps-train: " + line + "\n");
}

}  // namespace

TEST_CASE("options of an export that do not go together are refused as wrong usage") {
  check_trainer_refuses("predict --model m", 2, "name the pictures to predict, or --export onnx or half");
  check_trainer_refuses("predict --model m --export tflite", 2, "--export tflite: must be onnx or half");
  check_trainer_refuses("predict --model m a.png -o a.onnx", 2,
                        "--out: belongs to --export; for predictions use --json FILE");
  check_trainer_refuses("predict --model m --export half", 2,
                        "--export half: writes a model folder: name it by --out FOLDER");
  for (const std::string also : {"a.png", "--json a.json"})
    check_trainer_refuses("predict --model m --export onnx " + also, 2,
                          "--export: writes the network and predicts nothing: leave out pictures, --json, "
                          "--cameras, --undistort and --one-camera");
  check_trainer_refuses("predict --model none --export onnx", 1,
                        "none/model.json: is missing: name a folder that cps train has written");
}

TEST_CASE("training writes the network as ONNX unless told not to, and an export writes the same bytes",
          "[slow]") {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path.string(), data = folder + "/data";
  require_success("city --seed 1 --extent-m 300 -o " + folder + "/city.glb");
  require_success(tiny_recipe(folder + "/city.glb", data));
  const std::string train = "train --data " + data + " --width 32 --batch 4 --out " + folder;
  require_success(train + "/with --epochs 1");
  require_success(train + "/without --epochs 1 --onnx false");
  CHECK_FALSE(fs::exists(folder + "/without/model.onnx"));

  const std::string bytes = read_file(folder + "/with/model.onnx");
  require_success("predict --model " + folder + "/with --export onnx -o " + folder + "/there/a.onnx");
  CHECK((read_file(folder + "/there/a.onnx") == bytes));
  require_success("predict --model " + folder + "/without --export onnx");
  // The same options, data and so weights.
  CHECK((read_file(folder + "/without/model.onnx") == bytes));
  require_success("train --resume --data " + data + " --out " + folder + "/with");
  CHECK((read_file(folder + "/with/model.onnx") == bytes));

  check_trainer_refuses("predict --model " + folder + "/with --export onnx -o " + folder, 1,
                        folder + ": cannot be written: Is a directory");
  CHECK(fs::exists(folder + "/with/weights.pt"));
}
