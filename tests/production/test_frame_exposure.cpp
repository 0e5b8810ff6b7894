#include <catch2/catch.hpp>

#include "production/frame_exposure.h"

using namespace cps;

namespace {

/// A master, the given share of whose rows has one level and the others the other, exposed as metered.
Master master_of(double share, float level, float others) {
  constexpr int width = 40, height = 100;
  OIIO::ImageBuf picture(OIIO::ImageSpec(width, height, 3, OIIO::TypeFloat));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float value = y < share * height ? level : others;
      const float pixel[] = {value, value, value};
      picture.setpixel(x, y, pixel);
    }
  Master master;
  master.light.picture = picture;
  master.exposure = meter_exposure(picture);
  return master;
}

}  // namespace

TEST_CASE("frames are judged by the share of pixels that their exposure leaves black or makes white") {
  CHECK(frame_exposure(master_of(1, 5, 0)) == FrameExposure::good);
  CHECK(frame_exposure(master_of(0.5, 5, 0.2f)) == FrameExposure::good);
  CHECK(frame_exposure(master_of(1, 0, 0)) == FrameExposure::near_black);
  CHECK(frame_exposure(master_of(0.04, 5, 0)) == FrameExposure::near_black);  // a slit of light at the top
  CHECK(frame_exposure(master_of(0.2, 5, 0)) == FrameExposure::good);
  Master over = master_of(0.6, 5, 0.2f);
  over.exposure = 1;
  CHECK(frame_exposure(over) == FrameExposure::blown_out);
}

TEST_CASE("badly exposed views are counted, and the first is named whatever their order") {
  BadlyExposed views;
  CHECK(views.warnings().empty());
  views.add(FrameExposure::good, "set 0");
  views.add(FrameExposure::near_black, "set 2");
  views.add(FrameExposure::near_black, "set 1");
  views.add(FrameExposure::blown_out, "set 3");
  REQUIRE(views.warnings().size() == 2);
  CHECK_THAT(views.warnings()[0], Catch::StartsWith("warning: 2 views are nearly black, the first: set 1;"));
  CHECK_THAT(views.warnings()[1], Catch::StartsWith("warning: 1 view is mostly white, the first: set 3;"));
}
