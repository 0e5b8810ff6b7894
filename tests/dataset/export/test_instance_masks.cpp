#include <catch2/catch.hpp>

#include "dataset/export/instance_masks.h"
#include "tests/dataset/export/coco_masks.h"
#include "tests/dataset/export/dense_dataset.h"

using namespace cps;

namespace {

OIIO::ImageBuf label_of(int width, int height, const std::vector<std::uint16_t>& values) {
  OIIO::ImageBuf image(dense_spec(DenseLabel::instance, {width, height}));
  std::ranges::copy(values, static_cast<std::uint16_t*>(image.localpixels()));
  return image;
}

/// The compressed mask of a square from `first` to before `behind` in both directions, in an image of
/// 25 x 25 pixels.
std::string compressed_square(int first, int behind) {
  std::vector<std::uint16_t> values(25 * 25);
  for (int y = first; y < behind; ++y)
    for (int x = first; x < behind; ++x) values[25 * y + x] = 1;
  const OIIO::ImageBuf label = label_of(25, 25, values);
  const std::vector<InstanceMask> masks = instance_masks(label, label);
  REQUIRE(masks.size() == 1);
  return compressed_runs(masks[0].runs);
}

}  // namespace

TEST_CASE("compressed masks are those that COCO's own tools give") {
  // pycocotools.mask.encode() of such squares.
  CHECK(compressed_square(0, 5) == "05d00000000d?");
  CHECK(compressed_square(5, 10) == "R45d00000000b;");
  CHECK(compressed_square(20, 25) == "X`05d00000000");
  CHECK(compressed_runs(std::vector<std::uint32_t>{5, 2, 2, 2, 5}) == "52203");
  // By hand: the fourth run is -2, 30 in five bits; 625 is 17 + 19 * 32, whose highest bit asks for a third
  // group.
  CHECK(compressed_runs(std::vector<std::uint32_t>{2, 3, 1, 1}) == "231N");
  CHECK(compressed_square(0, 25) == "0ac0");
}

TEST_CASE("runs of every length come back from their text") {
  const Stream stream = make_stream(1, "runs");
  for (int n = 1; n < 200; ++n) {
    std::vector<std::uint32_t> runs;
    for (int i = 0; i < n % 9 + 1; ++i)  // of one bit, of two, up to 32
      runs.push_back(
          static_cast<std::uint32_t>(random_bits(substream(stream, n), i) >> (32 + (n + 7 * i) % 32)));
    const std::vector<std::int64_t> found = coco_runs(compressed_runs(runs));
    CHECK(std::ranges::equal(found, runs, [](std::int64_t a, std::uint32_t b) { return a == b; }));
  }
}

TEST_CASE("masks have the pixels of their object and class, and tell their box and area") {
  for (const ImageSize size : {ImageSize{64, 36}, ImageSize{1, 7}, ImageSize{9, 1}, ImageSize{1, 1}})
    for (std::uint64_t number = 0; number < 20; ++number) {
      const Pinhole camera{.width = size.width, .height = size.height};
      const OIIO::ImageBuf instance = made_up_label(DenseLabel::instance, camera, number),
                           semantic = made_up_label(DenseLabel::semantic, camera, number);
      const auto *objects = static_cast<const std::uint16_t*>(instance.localpixels()),
                 *classes = static_cast<const std::uint16_t*>(semantic.localpixels());
      const int width = size.width, pixels = width * size.height;
      std::map<std::pair<int, int>, std::vector<int>> wanted;
      for (int i = 0; i < pixels; ++i)
        if (objects[i] != 0) wanted[{objects[i], classes[i]}].push_back(i);
      const std::vector<InstanceMask> masks = instance_masks(instance, semantic);
      REQUIRE(masks.size() == wanted.size());
      for (std::size_t m = 0; const auto& [key, inside] : wanted) {
        const InstanceMask& mask = masks[m++];
        CHECK(std::pair(mask.instance, mask.class_id) == key);
        CHECK(mask.area_px == static_cast<std::int64_t>(inside.size()));
        const std::vector<bool> found =
            coco_mask(std::vector<std::int64_t>(mask.runs.begin(), mask.runs.end()), width, size.height);
        CHECK(std::ranges::count(found, true) == mask.area_px);
        CHECK(std::ranges::all_of(inside, [&](int i) { return found[i]; }));
        const auto [left, right] = std::ranges::minmax(inside, {}, [&](int i) { return i % width; });
        CHECK(mask.box.min() == Eigen::Vector2i(left % width, inside.front() / width));
        CHECK(mask.box.max() == Eigen::Vector2i(right % width, inside.back() / width));
      }
    }
}

TEST_CASE("pixels of no object belong to no mask") {
  const OIIO::ImageBuf nothing = label_of(3, 2, std::vector<std::uint16_t>(6)),
                       sky = label_of(3, 2, std::vector<std::uint16_t>(6, 23));
  CHECK(instance_masks(nothing, sky).empty());
}
