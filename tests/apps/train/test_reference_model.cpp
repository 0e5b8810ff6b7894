#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "tests/apps/cps_program.h"
#include "tests/apps/dataset/dataset_runs.h"
#include "tests/files_in.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Copies of the programs, beside which nothing is installed but what a test puts there.
struct CopiedPrograms {
  TemporaryFolder temporary;
  fs::path folder = fs::canonical(temporary.path), prefix = folder / "prefix",
           installed = prefix / "share/cps/models", own = folder / "my models";

  CopiedPrograms() {
    fs::create_directories(prefix / "bin");
    for (const char* program : {"cps", "cps-train"})
      fs::copy_file(fs::path(CPS_PROGRAM).parent_path() / program, prefix / "bin" / program);
  }

  /// Runs the copy of cps in `folder`, with this CPS_MODEL_DIR; without one if it is empty.
  ProgramRun run(const std::string& arguments, const fs::path& model_dir = {}) const {
    const std::string variable =
        model_dir.empty() ? "-u CPS_MODEL_DIR " : "CPS_MODEL_DIR=" + quoted(model_dir) + " ";
    return run_command("cd " + quoted(folder) + " && env " + variable + quoted(prefix / "bin" / "cps") + " " +
                       arguments);
  }
};

/// A reference model that is refused by its name when it is opened.
std::string write_broken_model(const fs::path& models) {
  const fs::path card = models / "cps-reference" / "model.json";
  write_file(card, std::string("{}\n"));
  return card.string();
}

void check_line(const ProgramRun& run, const std::string& expected) {
  INFO(run.output);
  CHECK(run.exit_status == 1);
  CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
  CHECK_THAT(run.output, Catch::StartsWith("cps-train: " + expected));
}

}  // namespace

TEST_CASE("without a model one line names the places where it was looked for and what to do") {
  const CopiedPrograms programs;
  const std::string installed = programs.installed.string(), own = programs.own.string(),
                    line = "cps-reference: there is no such model in ";
  check_line(programs.run("predict photo.jpg"), line + installed + ": name a model folder by --model");
  check_line(programs.run("eval --data data", programs.own),
             line + own + " or " + installed + ": name a model folder by --model");
}

TEST_CASE("the reference model is that of CPS_MODEL_DIR or else the installed one") {
  const CopiedPrograms programs;
  const std::string installed = write_broken_model(programs.installed);
  check_line(programs.run("predict photo.jpg"), installed);
  check_line(programs.run("eval --data data"), installed);
  check_line(programs.run("predict --export onnx", programs.own), installed);  // no model is there yet
  const std::string own = write_broken_model(programs.own);
  check_line(programs.run("predict photo.jpg", programs.own), own);
  check_line(programs.run("predict --model named photo.jpg", programs.own), "named/model.json: is missing");
  // What runs from the build tree finds the models of the source tree.
  CHECK(fs::equivalent(CPS_BUILD "/share/cps/models", CPS_SOURCE "/models"));
}

TEST_CASE("a model in half predicts without being named and cps eval writes into the working folder",
          "[slow]") {
  const CopiedPrograms programs;
  const std::string folder = programs.folder.string(), data = folder + "/data", model = folder + "/model";
  require_success("city --seed 1 --extent-m 300 -o " + folder + "/city.glb");
  require_success(tiny_recipe(folder + "/city.glb", data));
  require_success("train --data " + data + " --arch resnet10-32 --width 32 --batch 4 --epochs 1 --out " +
                  model);
  const fs::path reference = programs.installed / "cps-reference";
  require_success("predict --model " + model + " --export half -o " + quoted(reference));
  CHECK(files_in(reference) == 2);

  const std::string list = read_file(data + "/splits/train.txt"),
                    image = data + "/" + list.substr(0, list.find('\n'));
  const auto prediction = [&](const std::string& named) {
    const ProgramRun run = programs.run("predict " + named + image + " --json prediction.json");
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    return read_json(folder + "/prediction.json").at(0).at("prediction").at("fov").get<double>();
  };
  CHECK(prediction("") == Approx(prediction("--model " + model + " ")).epsilon(.02));

  const ProgramRun eval = programs.run("eval --data data --part train --bootstrap 0");
  INFO(eval.output);
  CHECK(eval.exit_status == 0);
  CHECK(read_json(folder + "/eval.json").at("model") == reference.string());
  CHECK(fs::exists(folder + "/eval.html"));
  CHECK(files_in(reference) == 2);
}

TEST_CASE("the trainer is installed with the models", "[slow]") {
  const TemporaryFolder folder;
  const fs::path prefix = folder.path / "prefix", models = prefix / "share/cps/models";
  const ProgramRun install =
      run_command("cmake --install " CPS_BUILD " --component trainer --prefix " + quoted(prefix));
  INFO(install.output);
  REQUIRE(install.exit_status == 0);
  CHECK(fs::exists(prefix / "bin" / "cps-train"));
  CHECK(read_file(models / "README.md") == read_file(CPS_SOURCE "/models/README.md"));
  for (const auto& entry : fs::directory_iterator(CPS_SOURCE "/models"))
    if (entry.is_directory())
      for (const char* file : {"model.json", "weights.pt", "card.md"}) {
        INFO(entry.path() / file);
        CHECK(fs::exists(models / entry.path().filename() / file));
      }
  REQUIRE(run_command("cmake -DBUILD=" CPS_BUILD " -P " CPS_SOURCE "/cmake/uninstall.cmake").exit_status ==
          0);
  CHECK(files_in(prefix) == 0);
}
