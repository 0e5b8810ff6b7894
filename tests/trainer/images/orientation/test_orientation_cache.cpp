#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "tests/trainer/street.h"
#include "tests/trainer/street_masters.h"
#include "trainer/images/image_cache.h"
#include "trainer/images/network_image.h"
#include "trainer/images/orientation/measure.h"
#include "trainer/training/online_images.h"
#include "trainer/training/samples.h"

using namespace cps;

namespace {

constexpr OrientationOptions measured{.measured = true, .max_width = 1392};

struct Streets {
  TemporaryFolder folder;
  Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{96, 54}, {80, 60}},
                                                               .fields_of_view = 1,
                                                               .lenses_per_part = 1,
                                                               .train_places = 3,
                                                               .val_places = 1,
                                                               .test_places = 1});
  std::vector<int> images = images_of(dataset, Part::train);
};

std::vector<std::int8_t> planes_of(const OrientationView& view) {
  return {view.planes, view.planes + plane_bytes(view.grid)};
}

}  // namespace

TEST_CASE("cached orientation is that of the image files at their own size") {
  const Streets streets;
  const auto file = streets.folder.path / "train.cache";
  const Reduction reduction{.width = 48};
  for (const bool is_new : {true, false}) {
    const ImageCache cache = load_image_cache(streets.dataset, streets.images, reduction, file, measured);
    CHECK((cache.decoded > 0) == is_new);
    REQUIRE(cache.orientations.size() == streets.images.size());
    for (std::size_t i = 0; i < streets.images.size(); ++i) {
      const DatasetImage& image = streets.dataset.images[streets.images[i]];
      const GrayImage whole = read_gray_image(streets.dataset.root / image.file);
      const GrayImage reduced = area_average(whole, reduced_size(whole.size, reduction));
      const Orientation expected = orientation_of(view_of(whole), reduced.size);
      CHECK(std::equal(reduced.pixels.begin(), reduced.pixels.end(), cache.images[i].pixels));
      REQUIRE(cache.orientations[i].grid == ImageSize{24, (reduced.size.height + 1) / 2});
      CHECK(planes_of(cache.orientations[i]) == expected.planes);
      CHECK(cache.orientations[i].numbers == expected.numbers);
      // Not what the reduced image would give.
      CHECK(orientation_of(view_of(reduced), reduced.size).numbers != expected.numbers);
    }
  }
}

TEST_CASE("a cache without orientation, or of another width, is made again, and not misread") {
  const Streets streets;
  const auto file = streets.folder.path / "train.cache";
  const auto load = [&](const OrientationOptions& orientation) {
    return load_image_cache(streets.dataset, streets.images, {.width = 48}, file, orientation);
  };
  const int count = static_cast<int>(streets.images.size());
  CHECK(load({}).decoded == count);
  const std::string plain = read_file(file);
  CHECK_THAT(plain.substr(0, 4096), !Catch::Contains("orientation"));
  for (const OrientationView& view : load({}).orientations) CHECK(view.planes == nullptr);
  CHECK(load(measured).decoded == count);
  CHECK(load(measured).decoded == 0);
  CHECK(load({.measured = true, .max_width = 60}).decoded == count);
  CHECK(load({}).decoded == count);
  CHECK(read_file(file) == plain);
}

TEST_CASE("orientation in a cache does not depend on threads") {
  const Streets streets;
  const auto bytes = [&](const char* name) {
    load_image_cache(streets.dataset, streets.images, {.width = 48}, streets.folder.path / name, measured);
    return read_file(streets.folder.path / name);
  };
  std::string one;
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    one = bytes("one");
  }
  CHECK(bytes("many") == one);
}

TEST_CASE("an online lens' orientation is that of its picture, after augmentation") {
  const Streets streets;
  keep_street_masters(streets.folder.path / "data", {174, 64}, 3);
  TrainOptions options;
  options.online_lenses = true;
  options.orientation = measured;
  const Batch batch{0, 1, 2};
  std::vector<OrientationNumbers> plain;
  for (const double probability : {0., 1.}) {
    options.augmentation.probability = probability;
    options.reduction.width = 174;  // the network gets the picture that is measured
    const TrainingSet set = online_images(streets.dataset, options, streets.folder.path / "masters.cache");
    for (const double deviation : set.orientation.number_deviation) CHECK(deviation > 0);
    const std::vector<ShownImage> shown = show(set, batch, options, 1);
    for (std::size_t n = 0; n < batch.size(); ++n) {
      const Orientation expected = orientation_of(view_of(shown[n].pixels), shown[n].pixels.size);
      CHECK(shown[n].orientation.planes == expected.planes);
      CHECK(shown[n].orientation.numbers == expected.numbers);
      if (probability == 0)
        plain.push_back(expected.numbers);
      else
        CHECK(expected.numbers != plain[n]);
    }

    // A smaller network sees the same picture, more finely than its image, in larger cells.
    options.reduction.width = 58;
    const TrainingSet small = online_images(streets.dataset, options, streets.folder.path / "masters.cache");
    const std::vector<ShownImage> seen = show(small, batch, options, 1);
    for (std::size_t n = 0; n < batch.size(); ++n) {
      CHECK(seen[n].pixels.size.width == 58);
      CHECK(seen[n].orientation.grid == orientation_grid(seen[n].pixels.size));
      CHECK(seen[n].measured.pixels.empty());
      // Of the picture that the wider network gets whole.
      CHECK(seen[n].orientation.numbers ==
            orientation_of(view_of(shown[n].pixels), seen[n].pixels.size).numbers);
    }
  }
}

TEST_CASE("stored images keep their orientation under augmentation, which changes the reduced image alone") {
  const Streets streets;
  TrainOptions options;
  options.reduction.width = 48;
  options.orientation = measured;
  options.mirror = false;
  options.augmentation.probability = 1;
  const auto samples = std::make_shared<const Samples>(
      load_samples(streets.dataset, Part::train, {.reduction = options.reduction, .orientation = measured},
                   streets.folder.path / "train.cache"));
  const TrainingSet set = fixed_images(samples, options);
  CHECK(set.orientation.plane_deviation[0] > 0);
  const std::vector<ShownImage> shown = show(set, {0, 1}, options, 1);
  for (int n : {0, 1}) {
    CHECK(shown[n].orientation.planes == planes_of(samples->cache.orientations[n]));
    const std::uint8_t* stored = samples->cache.images[n].pixels;
    CHECK_FALSE(std::equal(shown[n].pixels.pixels.begin(), shown[n].pixels.pixels.end(), stored));
  }
}
