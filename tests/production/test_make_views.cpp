#include <atomic>
#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("make_views writes the planned files and enters every view in the journal") {
  const TinyDataset dataset;
  REQUIRE(dataset.plan.views.size() == 6);
  std::int64_t advanced = 0;
  const MakeViewsSummary summary =
      dataset.make({.advance = [&](std::int64_t images, const std::string&) { advanced += images; }});
  CHECK(summary.views == 6);
  CHECK(summary.images == 12);
  CHECK(advanced == 12);
  CHECK_FALSE(summary.is_interrupted);

  std::set<std::string> planned;
  for (std::int64_t v = 0; v < 6; ++v)
    for (const std::string& file : dataset.files_of(v)) planned.insert(file);
  REQUIRE(planned.size() == 12);
  const auto contents = dataset.contents();
  CHECK(contents.size() == planned.size());
  for (const std::string& file : planned) CHECK(contents.contains(file));

  const auto records = read_journals(dataset.root).views;
  CHECK(records.size() == 6);
  for (const auto& [view, record] : records)
    for (const ImageRecord& image : record.images) {
      CHECK(image.sha256 == sha256(contents.at(image.file)));
      CHECK(image.bytes == contents.at(image.file).size());
    }
  CHECK(dataset.remaining().empty());
}

TEST_CASE("labels are written for the groups of the given views alone") {
  const TinyDataset dataset;
  write_labels(dataset.plan, {0}, dataset.root);
  std::set<std::string> expected;
  for (int g : dataset.plan.views[0].groups)
    expected.insert(dataset.plan.groups[g].folder + "/calibration.json");
  std::set<std::string> written;
  for (const auto& [name, bytes] : dataset.contents()) written.insert(name);
  CHECK(written == expected);
}

TEST_CASE("an error in one view is thrown, and the other views are completed") {
  const TinyDataset dataset, whole;
  whole.make();
  const std::vector<std::string> last = dataset.files_of(5);
  fs::create_directories(dataset.root / last[0]);  // no file can get this name
  CHECK_THROWS_WITH(dataset.make(), Catch::Contains(fs::path(last[0]).filename().string()));
  CHECK(dataset.remaining() == std::vector<std::int64_t>{5});
  for (const auto& [name, bytes] : dataset.contents()) CHECK(whole.contents().at(name) == bytes);
  CHECK(fs::is_regular_file(dataset.root / last[1]));

  fs::remove(dataset.root / last[0]);
  CHECK(dataset.make().views == 1);
  CHECK(dataset.contents() == whole.contents());
}

TEST_CASE("a scene that cannot be loaded ahead is reported, and the views of those before it are completed") {
  const TinyDataset dataset{.scene_count = 3}, whole{.scene_count = 3};
  whole.make();
  REQUIRE(dataset.plan.views.size() == 18);
  fs::rename(dataset.scenes[1], dataset.folder.path / "away");
  CHECK_THROWS_WITH(dataset.make(), Catch::Contains("street1.gltf"));
  std::vector<std::int64_t> of_later_scenes;
  for (std::int64_t v = 6; v < 18; ++v) of_later_scenes.push_back(v);
  CHECK(dataset.remaining() == of_later_scenes);

  fs::rename(dataset.folder.path / "away", dataset.scenes[1]);
  CHECK(dataset.make().views == 12);
  CHECK(dataset.contents() == whole.contents());
}

TEST_CASE("a run stopped while the next scene loads is continued") {
  const TinyDataset dataset{.scene_count = 2}, whole{.scene_count = 2};
  whole.make();
  // It is asked before each view and after each tile: the runs stop at ever later moments.
  int runs = 0;
  for (; !dataset.remaining().empty(); ++runs) {
    std::atomic<int> asked = 0;
    dataset.make({.must_stop = [&] { return ++asked > 10 * (runs + 1); }});
    REQUIRE(runs < 100);
  }
  CHECK(runs > 1);
  CHECK(dataset.contents() == whole.contents());
}

TEST_CASE("a stopped run gives up the view being rendered, leaves no half file, and is continued") {
  const TinyDataset dataset, whole;
  whole.make();
  std::atomic<bool> stop = true;
  const Watch watch{.must_stop = [&] { return stop.load(); },
                    .advance = [&](std::int64_t, const std::string&) { stop = true; }};
  const MakeViewsSummary none = dataset.make(watch);
  CHECK(none.views == 0);
  CHECK(none.is_interrupted);
  CHECK(dataset.contents().empty());

  // Stopped while the first view is being rendered.
  std::atomic<int> asked = 0;
  const MakeViewsSummary given_up = dataset.make({.must_stop = [&] { return ++asked > 2; }});
  CHECK(given_up.views == 0);
  CHECK(given_up.is_interrupted);
  CHECK(dataset.contents().empty());

  stop = false;
  const MakeViewsSummary some = dataset.make(watch);  // stops once one view is complete
  CHECK(some.is_interrupted);
  CHECK(some.views >= 1);
  CHECK(some.views < 6);
  std::set<std::string> expected;
  for (const auto& [view, record] : read_journals(dataset.root).views)
    for (const ImageRecord& image : record.images) expected.insert(image.file);
  std::set<std::string> written;
  for (const auto& [name, bytes] : dataset.contents()) written.insert(name);
  CHECK(written == expected);

  CHECK(dataset.make().views == 6 - some.views);
  CHECK(dataset.contents() == whole.contents());
}

TEST_CASE("views with a lost or shortened image or a damaged journal line remain") {
  const TinyDataset dataset;
  dataset.make();
  fs::remove(dataset.root / dataset.files_of(1)[0]);
  fs::resize_file(dataset.root / dataset.files_of(3)[1], 10);
  CHECK(dataset.remaining() == std::vector<std::int64_t>{1, 3});

  const RemainingViews remaining = remaining_views(dataset.plan, {}, dataset.root, {});
  CHECK(remaining.shard_images == 12);
  CHECK(remaining.made_images == 8);

  std::set<std::int64_t> damaged;
  for (const auto& entry : fs::directory_iterator(dataset.root / ".cps")) {
    std::string lines = entry.is_regular_file() ? read_file(entry.path()) : "";
    if (lines.find("\"view\"") == lines.npos) continue;
    damaged.insert(nlohmann::json::parse(lines.substr(0, lines.find('\n'))).at("view").get<std::int64_t>());
    lines[0] = '#';
    write_file(entry.path(), lines);
  }
  REQUIRE(damaged.size() == 1);
  std::vector<std::string> notes;
  std::set<std::int64_t> expected{1, 3};
  expected.merge(damaged);
  const std::vector<std::int64_t> views =
      dataset.remaining({.note = [&](const std::string& line) { notes.push_back(line); }});
  CHECK(std::set<std::int64_t>(views.begin(), views.end()) == expected);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::Contains("1 damaged lines"));
}
