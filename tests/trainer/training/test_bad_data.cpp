#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

Dataset small_streets(const std::filesystem::path& folder) {
  return make_street_dataset(
      folder, {.sizes = {{96, 54}}, .fields_of_view = 2, .lenses_per_part = 2, .train_places = 3});
}

TrainOptions one_epoch() {
  TrainOptions options;
  options.reduction.width = 48;
  options.epochs = 1;
  options.batch_size = 4;
  return options;
}

/// Changes a label's text and expects the dataset to be refused in one line that starts with its file.
void check_refused_label(const Dataset& dataset, const std::string& from, const std::string& to) {
  const std::filesystem::path file = dataset.root / dataset.groups[1].folder / "calibration.json";
  const std::string good = read_file(file);
  std::string bad = good;
  const std::size_t at = bad.find(from);
  REQUIRE(at != std::string::npos);
  bad.replace(at, bad.find_first_of(",\n", at) - at, to);
  write_file(file, bad);
  INFO(from << " -> " << to);
  CHECK_THROWS_WITH(read_dataset(dataset.root), Catch::StartsWith(file.string()) && !Catch::Contains("\n"));
  write_file(file, good);
}

}  // namespace

TEST_CASE("a corrupt image is named, and refused or left out as asked") {
  const TemporaryFolder folder;
  const Dataset dataset = small_streets(folder.path / "data");
  const std::filesystem::path corrupt = dataset.root / dataset.images[3].file,
                              missing = dataset.root / dataset.images[5].file;
  REQUIRE(dataset.images[5].part == Part::train);
  write_file(corrupt, std::string_view(read_file(corrupt)).substr(0, 300));
  CHECK_THROWS_WITH(train(dataset, folder.path / "model", one_epoch(), false, {}),
                    Catch::StartsWith(corrupt.string()) && !Catch::Contains("\n"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "model/model.json"));

  std::filesystem::remove(missing);
  TrainOptions options = one_epoch();
  options.skip_bad_images = true;
  const TrainSummary summary = train(dataset, folder.path / "model", options, false, {});
  CHECK(summary.training_images == 12 - 2);
  REQUIRE(summary.skipped.size() == 2);
  CHECK_THAT(summary.skipped[0] + summary.skipped[1],
             Catch::Contains(corrupt.string()) && Catch::Contains(missing.string()));

  for (const DatasetImage& image : dataset.images)
    if (image.part == Part::train) write_file(dataset.root / image.file, std::string_view("none"));
  CHECK_THROWS_WITH(train(dataset, folder.path / "none", options, false, {}), Catch::Contains("(and "));
}

TEST_CASE("labels with invalid numbers, or of another schema, are refused by name") {
  const TemporaryFolder folder;
  const Dataset dataset = small_streets(folder.path / "data");
  check_refused_label(dataset, "\"schema\":", "\"schema\": 3");
  check_refused_label(dataset, "\"k1\":", "\"k1\": null");
  check_refused_label(dataset, "\"k1\":", "\"k1\": NaN");
  check_refused_label(dataset, "\"k1\":", "\"k1\": 1e999");
  check_refused_label(dataset, "\"fov\":", "\"fov\": \"wide\"");
  CHECK_NOTHROW(read_dataset(dataset.root));
}

TEST_CASE("an empty dataset is refused in one line") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(read_dataset(folder.path), Catch::StartsWith(folder.path.string() + ": "));
  const Dataset dataset = small_streets(folder.path / "data");
  write_file(dataset.root / "splits/train.txt", std::string_view());
  CHECK_THROWS_WITH(train(read_dataset(dataset.root), folder.path / "model", one_epoch(), false, {}),
                    Catch::StartsWith((dataset.root / "splits/train.txt").string()));
}
