#include <catch2/catch.hpp>

#include "dataset/job/frames.h"
#include "dataset/verify/verify_plan.h"
#include "tests/dataset/edit_csv.h"
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
  CHECK(planned == 17);
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
