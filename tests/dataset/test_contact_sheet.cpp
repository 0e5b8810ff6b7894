#include <OpenImageIO/imagebufalgo.h>

#include <catch2/catch.hpp>

#include "dataset/contact_sheet.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

TEST_CASE("a contact sheet shows each view in its tile") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, plan);
  const ContactSheetOptions options{.rows_per_set = 1, .columns = 3, .tile_width_px = 64};
  const OIIO::ImageBuf sheet = contact_sheet(read_dataset(root), options);
  CHECK(sheet.spec().width == 6 + 3 * (64 + 6));
  // At its own size a tile is the picture itself: the first view's undistorted image stands top left.
  OIIO::ImageBuf first((root / plan.groups[0].folder / "000000.png").string());
  REQUIRE(first.read(0, 0, true, OIIO::TypeDesc::FLOAT));
  float expected[3], shown[3];
  for (int x = 0; x < 64; x += 9) {
    first.getpixel(x, 20, 0, expected, 3);
    sheet.getpixel(6 + x, 6 + 20, 0, shown, 3);
    for (int c = 0; c < 3; ++c) CHECK(shown[c] == Approx(expected[c]).margin(0.02));
  }
  // An image of one channel is gray, not red.
  const OIIO::ImageSpec spec = first.spec();
  OIIO::ImageBuf gray(OIIO::ImageSpec(spec.width, spec.height, 1, OIIO::TypeDesc::UINT8));
  OIIO::ImageBufAlgo::fill(gray, {0.5f});
  REQUIRE(gray.write((root / plan.groups[0].folder / "000000.png").string()));
  contact_sheet(read_dataset(root), options).getpixel(6 + 20, 6 + 20, 0, shown, 3);
  for (int c = 0; c < 3; ++c) CHECK(shown[c] == Approx(.5).margin(.01));

  std::filesystem::remove(root / plan.groups[0].folder / "000000.png");
  CHECK_THROWS_WITH(contact_sheet(read_dataset(root), options), Catch::Contains("000000.png"));
}

TEST_CASE("invalid contact sheet options are refused by name") {
  CHECK(ContactSheetOptions{}.fault() == "");
  CHECK(ContactSheetOptions{.columns = 0}.fault() == "columns: must lie in [1, 100]");
  CHECK(ContactSheetOptions{.tile_width_px = 10}.fault() == "tile-width: must lie in [64, 4096]");
}
