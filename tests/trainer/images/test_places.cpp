#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/images/places.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

/// Two sets of 50 places, each seen through three lenses; only the names of a dataset, without files.
Dataset dataset_of_names() {
  Dataset dataset{.root = "data", .groups = {}, .images = {}};
  for (const char* set : {"480x270_hfov060", "480x270_hfov090"})
    for (int lens = 0; lens < 3; ++lens) {
      DatasetGroup group;
      group.folder = std::filesystem::path(set) / ("front_lens000" + std::to_string(lens));
      dataset.groups.push_back(group);
      for (int place = 0; place < 50; ++place)
        dataset.images.push_back({group.folder / (std::to_string(1000 + place) + ".png"),
                                  static_cast<int>(dataset.groups.size()) - 1, Part::train});
    }
  return dataset;
}

/// The masters of the same places.
std::vector<KeptMaster> masters_of_names() {
  std::vector<KeptMaster> masters;
  for (const char* set : {"480x270_hfov060", "480x270_hfov090"})
    for (int place = 0; place < 50; ++place) {
      masters.emplace_back();
      masters.back().file =
          std::filesystem::path("masters") / set / ("rear_left_" + std::to_string(1000 + place) + ".exr");
    }
  return masters;
}

std::set<std::string> places_among(const Dataset& dataset, const std::vector<int>& images) {
  std::set<std::string> places;
  for (int i : images) places.insert(place_of(dataset, dataset.images[i]));
  return places;
}

}  // namespace

TEST_CASE("a share of the places has whole places and is a part of every larger share") {
  const Dataset dataset = dataset_of_names();
  const std::vector<int> all = images_of(dataset, Part::train);
  REQUIRE(places_among(dataset, all).size() == 100);
  CHECK(share_of_places(dataset, all, 1) == all);
  std::vector<int> smaller;
  for (const auto& [share, count] : std::map<double, std::size_t>{
           {1e-6, 1}, {.25, 25}, {.5, 50}, {.754, 75}, {.756, 76}, {.999, 100}, {1, 100}}) {
    const std::vector<int> images = share_of_places(dataset, all, share);
    INFO("share " << share);
    CHECK(places_among(dataset, images).size() == count);
    CHECK(images.size() == 3 * count);  // all images of a place
    CHECK(std::ranges::is_sorted(images));
    CHECK(std::ranges::includes(images, smaller));
    smaller = images;
  }
}

TEST_CASE("which places are chosen is independent of their order and of the set") {
  const Dataset dataset = dataset_of_names();
  std::vector<int> all = images_of(dataset, Part::train);
  std::vector<int> chosen = share_of_places(dataset, all, .5);
  std::ranges::reverse(all);
  std::vector<int> backwards = share_of_places(dataset, all, .5);
  std::ranges::reverse(backwards);
  CHECK(backwards == chosen);
  // Of 50 places in each set, 25 ± 2.5 are drawn (hypergeometric): six standard deviations, and not the same
  // numbers in both.
  std::array<std::set<std::string>, 2> numbers;
  for (int i : chosen)
    numbers[dataset.images[i].group / 3].insert(dataset.images[i].file.filename().string());
  CHECK(numbers[0].size() + numbers[1].size() == 50);
  CHECK(numbers[0].size() >= 10);
  CHECK(numbers[1].size() >= 10);
  CHECK(numbers[0] != numbers[1]);
}

TEST_CASE("kept masters are chosen by the same places as images") {
  const Dataset dataset = dataset_of_names();
  const std::vector<KeptMaster> masters = masters_of_names();
  CHECK(share_of_places(masters, 1).size() == 100);
  for (double share : {.1, .5}) {
    std::set<std::string> of_masters;
    for (const KeptMaster& master : share_of_places(masters, share)) of_masters.insert(place_of(master));
    CHECK(of_masters ==
          places_among(dataset, share_of_places(dataset, images_of(dataset, Part::train), share)));
  }
}

TEST_CASE("training on a share of the places sees those and all validation images") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{64, 36}},
                                                                     .fields_of_view = 2,
                                                                     .lenses_per_part = 2,
                                                                     .train_places = 4,
                                                                     .val_places = 1,
                                                                     .test_places = 1});
  TrainOptions options;
  options.architecture = "resnet18-16";
  options.reduction.width = 64;
  options.epochs = 1;
  options.batch_size = 4;
  options.places_share = .5;
  const TrainSummary summary = train(dataset, folder.path / "model", options, false, {});
  CHECK(images_of(dataset, Part::train).size() == 16);
  CHECK(summary.training_images == 8);  // four of eight places, two lenses each
  CHECK(summary.validation_images == 4);
  CHECK_THAT(read_file(folder.path / "model" / "model.json"), Catch::Contains("\"places_share\": 0.5"));
}
