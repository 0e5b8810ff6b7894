#include <catch2/catch.hpp>

#include "dataset/job/frames.h"
#include "dataset/verify/verify_plan.h"
#include "tests/dataset/edit_csv.h"
#include "tests/dataset/old_dataset.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

TEST_CASE("a dataset made by the plan agrees with it") {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  CHECK(faults_against_plan(folder.path, plan) == std::vector<std::string>{});
}

TEST_CASE("exactly the columns that the plan decides are compared with it") {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  const std::string leaf = plan.groups[1].folder + "/frames.csv";
  const std::string whole = read_file(folder.path / leaf);
  int planned = 0;
  for (const FrameColumn& column : frame_columns()) {
    INFO(column.name);
    edit_column(folder.path / leaf, column.name, [](const std::string& text) { return text + "1"; });
    const std::vector<std::string> faults = faults_against_plan(folder.path, plan);
    CHECK(faults.empty() != column.is_planned);
    for (const std::string& fault : faults)
      CHECK_THAT(fault,
                 Catch::StartsWith(leaf + ": ") &&
                     Catch::Contains(std::string(column.name) == "file" ? ": is missing, but"
                                                                        : std::string(": ") + column.name));
    planned += column.is_planned;
    write_file(folder.path / leaf, whole);
  }
  CHECK(planned == 20);
}

TEST_CASE("a label that differs from the plan's is named") {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  const std::string label = plan.groups[0].folder + "/calibration.json";
  write_file(folder.path / label, read_file(folder.path / label) + " ");
  CHECK(faults_against_plan(folder.path, plan) ==
        std::vector<std::string>{label + ": is not what the recipe gives"});
}

TEST_CASE("a dataset of schema 1 is compared with what schema 1 says") {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  const std::filesystem::path label = folder.path / plan.groups[0].folder / "calibration.json";
  const std::string today = read_file(label);
  make_old(folder.path);
  CHECK(faults_against_plan(folder.path, plan) == std::vector<std::string>{});
  const std::vector<std::string> is_wrong = {plan.groups[0].folder +
                                             "/calibration.json: is not what the recipe gives"};
  // What the plan says of schema 2 is right; a mixture of both is not.
  write_file(label, today);
  CHECK(faults_against_plan(folder.path, plan) == std::vector<std::string>{});
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(today);
  json["schema"] = 1;
  write_json(label, json);
  CHECK(faults_against_plan(folder.path, plan) == is_wrong);
  make_old(folder.path);
  edit_column(folder.path / plan.groups[0].folder / "frames.csv", "camera_qx",
              [](const std::string& text) { return text + "1"; });
  REQUIRE_FALSE(faults_against_plan(folder.path, plan).empty());
  CHECK_THAT(faults_against_plan(folder.path, plan)[0], Catch::Contains("camera_qx: is not what"));
}
