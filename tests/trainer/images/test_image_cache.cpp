#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/images/image_cache.h"
#include "trainer/training/samples.h"

using namespace cps;

TEST_CASE("area averaging takes the mean of what each pixel covers") {
  GrayImage image{{6, 4}, {}};
  for (int i = 0; i < 24; ++i) image.pixels.push_back(static_cast<std::uint8_t>(10 * (i % 6) + 3 * (i / 6)));
  const GrayImage half = area_average(image, {3, 2});
  REQUIRE(half.size == ImageSize{3, 2});
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)  // means of a linear ramp: x at 2x + .5, y at 2y + .5, halves rounded up
      CHECK(half.pixels[y * 3 + x] == std::lround(10 * (2 * x + .5) + 3 * (2 * y + .5)));

  // Fractions: 3 pixels into 2; the middle one belongs to both by half.
  const GrayImage three{{3, 1}, {0, 60, 240}};
  const GrayImage two = area_average(three, {2, 1});
  CHECK(two.pixels == std::vector<std::uint8_t>{20, 180});
}

TEST_CASE("colour becomes Rec. 709 luma of the encoded values; gray stays as it is") {
  const TemporaryFolder folder;
  const auto read_back = [&](int channels, const std::vector<std::uint8_t>& pixel, const char* name) {
    const std::string file = folder.path / name;
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), pixel.begin(), pixel.end());
    auto out = OIIO::ImageOutput::create(file);
    OIIO::ImageSpec spec(8, 8, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    REQUIRE(out->open(file, spec));
    REQUIRE(out->write_image(OIIO::TypeDesc::UINT8, pixels.data()));
    out->close();
    return static_cast<int>(read_gray_image(file).pixels[27]);
  };
  CHECK(read_back(3, {255, 0, 0}, "red.png") == 54);
  CHECK(read_back(3, {0, 255, 0}, "green.png") == 182);
  CHECK(read_back(3, {0, 0, 255}, "blue.png") == 18);
  CHECK(read_back(3, {90, 90, 90}, "gray.png") == 90);
  CHECK(read_back(4, {90, 90, 90, 128}, "alpha.png") == 90);
  CHECK(read_back(1, {77}, "one.png") == 77);
  CHECK(read_back(3, {120, 120, 120}, "photo.jpg") == 120);
}

TEST_CASE("the network image's size follows the option") {
  CHECK(reduced_size({480, 270}, {.width = 240}) == ImageSize{240, 135});
  CHECK(reduced_size({1392, 512}, {.factor = 4}) == ImageSize{348, 128});
  CHECK(reduced_size({1920, 1080}, {.factor = 4}) == ImageSize{480, 270});
  CHECK(reduced_size({100, 60}, {.width = 240}) == ImageSize{100, 60});  // never enlarged
}

TEST_CASE("the cache holds the decoded images, is found again, and notices a change") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path, {.sizes = {{96, 54}, {80, 60}},
                                                            .fields_of_view = 1,
                                                            .lenses_per_part = 1,
                                                            .train_places = 3,
                                                            .val_places = 1,
                                                            .test_places = 1});
  const std::vector<int> images = images_of(dataset, Part::train);
  const std::filesystem::path file = folder.path / "train.cache";
  const Reduction reduction{.width = 48};
  const auto check = [&](const ImageCache& cache) {
    REQUIRE(cache.images.size() == images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
      const GrayImage whole = read_gray_image(dataset.root / dataset.images[images[i]].file);
      const GrayImage expected = area_average(whole, reduced_size(whole.size, reduction));
      CHECK(cache.originals[i] == whole.size);
      REQUIRE(cache.images[i].size == expected.size);
      CHECK(std::equal(expected.pixels.begin(), expected.pixels.end(), cache.images[i].pixels));
    }
  };
  ImageCache cache = load_image_cache(dataset, images, reduction, file);
  CHECK(cache.decoded == static_cast<int>(images.size()));
  check(cache);
  cache = load_image_cache(dataset, images, reduction, file);
  CHECK(cache.decoded == 0);
  check(cache);
  CHECK(load_image_cache(dataset, images, {.width = 40}, file).decoded > 0);

  const std::filesystem::path touched = dataset.root / dataset.images[images[1]].file;
  load_image_cache(dataset, images, reduction, file);
  std::filesystem::copy_file(dataset.root / dataset.images[images[0]].file, touched,
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::last_write_time(touched,
                                   std::filesystem::last_write_time(touched) + std::chrono::seconds(5));
  cache = load_image_cache(dataset, images, reduction, file);
  CHECK(cache.decoded == static_cast<int>(images.size()));
  check(cache);

  // A cache that is cut short is made again.
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  CHECK(load_image_cache(dataset, images, reduction, file).decoded > 0);
}

TEST_CASE("a bad image is named, and leaves no cache behind") {
  const TemporaryFolder folder;
  const Dataset dataset =
      make_street_dataset(folder.path, {.sizes = {{96, 54}}, .fields_of_view = 1, .lenses_per_part = 1});
  const std::vector<int> images = images_of(dataset, Part::train);
  const std::filesystem::path bad = dataset.root / dataset.images[images[2]].file,
                              cache = folder.path / "train.cache";
  const std::string whole = read_file(bad);
  const auto error = [&] {
    try {
      load_image_cache(dataset, images, {.width = 48}, cache);
    } catch (const std::runtime_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const auto check = [&](const std::string& what) {
    CHECK_THAT(what, Catch::StartsWith(bad.string() + ": "));
    CHECK(what.find('\n') == std::string::npos);
    CHECK_FALSE(std::filesystem::exists(cache));
  };
  for (std::size_t length : {std::size_t{0}, std::size_t{20}, whole.size() / 2}) {
    write_file(bad, std::string_view(whole).substr(0, length));
    check(error());
  }
  std::string flipped = whole;
  for (std::size_t i = whole.size() / 2; i < whole.size() / 2 + 8; ++i)
    flipped[i] = static_cast<char>(~flipped[i]);
  write_file(bad, flipped);
  check(error());
  write_file(bad, "no picture at all");
  check(error());
  std::filesystem::remove(bad);
  check(error());
}

TEST_CASE("an image that is not of its label's size is refused") {
  const TemporaryFolder folder;
  Dataset dataset =
      make_street_dataset(folder.path, {.sizes = {{96, 54}}, .fields_of_view = 1, .lenses_per_part = 1});
  for (DatasetGroup& group : dataset.groups) group.label.camera.width = 100;
  CHECK_THROWS_WITH(load_image_cache(dataset, images_of(dataset, Part::train), {}, {}),
                    Catch::Contains("96x54"));
}
