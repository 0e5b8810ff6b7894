#include <catch2/catch.hpp>

#include "dataset/job/frames.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

TEST_CASE("frames.csv reads back, whatever a street is called") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  PlannedView view;
  view.street = "Main St, \"old\"";
  view.part = Part::val;
  view.condition = 3;
  const ViewRecord record;
  const ImageRecord image{.file = "set/leaf/000002.png", .sensor = {}, .sha256 = "ab", .pixels_sha256 = "cd"};
  write_file(folder / "frames.csv", frames_csv({{&view, &record, &image}}));
  const std::vector<FrameRow> rows = read_frames_csv(folder / "frames.csv");
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].file == "000002.png");
  CHECK(rows[0].part == "val");
  CHECK(rows[0].condition == "3");
  CHECK(rows[0].street == view.street);
  CHECK(rows[0].sha256 == "ab");
}

TEST_CASE("a frames.csv that is cut short or lacks a column is refused by line or name") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  write_file(folder / "a.csv",
             std::string("file,part,condition,street,exposure,exposure_bias_ev,sha256\nx.png,train\n"));
  CHECK_THROWS_WITH(read_frames_csv(folder / "a.csv"), Catch::Contains("a.csv: line 2"));
  write_file(folder / "b.csv", std::string("file,part,condition,sha256\n"));
  CHECK_THROWS_WITH(read_frames_csv(folder / "b.csv"), Catch::Contains("street"));
}
