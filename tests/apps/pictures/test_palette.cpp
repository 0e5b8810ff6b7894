#include <png.h>

#include "apps/pictures/picture_file.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int map_width = 20, map_height = 10, classes = 21;

/// A label picture as segmentation sets have it: class numbers with a palette, in which two classes have the
/// same colour.
void write_labels(const fs::path& file) {
  std::vector<png_byte> numbers, colours;
  for (int i = 0; i < map_width * map_height; ++i) numbers.push_back(static_cast<png_byte>(i % classes));
  for (int i = 0; i < classes; ++i) {
    const auto shade = static_cast<png_byte>(i == 7 ? 30 : 10 * i);
    colours.insert(colours.end(), {shade, static_cast<png_byte>(255 - shade), 3, 255});
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = map_width;
  png.height = map_height;
  png.format = PNG_FORMAT_RGBA_COLORMAP;
  png.colormap_entries = classes;
  REQUIRE(png_image_write_to_file(&png, file.c_str(), 0, numbers.data(), 0, colours.data()) != 0);
}

}  // namespace

TEST_CASE("class numbers of a palette picture stay numbers, with their colours") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.png", copy = folder.path / "b.png";
  write_labels(file);
  const Picture labels = read_picture(file, Encoding::automatic, Resampling::nearest, map_width, map_height);
  REQUIRE(labels.pixels.spec().nchannels == 1);
  const auto* numbers = static_cast<const std::uint8_t*>(labels.pixels.localpixels());
  for (int i = 0; i < map_width * map_height; ++i) REQUIRE(numbers[i] == i % classes);
  write_picture(copy, labels.pixels, labels);
  CHECK(is_palette_png(copy));
  const Picture again = read_picture(copy, Encoding::automatic, Resampling::nearest, map_width, map_height);
  CHECK(again.palette == labels.palette);
  CHECK(std::equal(numbers, numbers + map_width * map_height,
                   static_cast<const std::uint8_t*>(again.pixels.localpixels())));
  CHECK_THROWS_WITH(write_picture(folder.path / "b.tif", labels.pixels, labels), Catch::Contains("palette"));
}

TEST_CASE("as a photo, a palette picture is its colours") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.png";
  write_labels(file);
  const Picture photo = read_picture(file, Encoding::automatic, Resampling::footprint, map_width, map_height);
  CHECK(photo.file.nchannels == 3);
  CHECK(photo.pixels.getchannel(4, 0, 0, 0) == Approx(linear(40 / 255.0)).epsilon(1e-4));
}
