#include <catch2/catch.hpp>
#include <cmath>

#include "tests/trainer/images/orientation/drawings.h"
#include "trainer/evaluation/page/edge_strokes.h"
#include "trainer/images/network_image.h"

using namespace cps;
using Eigen::Vector2d;

namespace {

/// The sine of the angle between two directions; 0 where they are parallel.
double sine_between(const Vector2d& a, const Vector2d& b) {
  return (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm());
}

/// Evidence of a picture of 400×200 in 4×2 blocks, all of weight 100 and tilt 0; its model has no tilts.
struct BlockPicture {
  FrameEvidence frame;
  TiltModel model;

  BlockPicture() {
    const ImageSize picture{400, 200}, orientation{16, 8};
    frame.edges = {picture, fit_grid(orientation), std::vector<float>(16, 100), std::vector<float>(16)};
    frame.centres = fit_block_centres(picture, orientation);
    model.tilt.resize(16);
    model.has_tilt.resize(16);
  }
};

/// The edges of a picture as its network image has them, without a fit.
std::vector<EdgeStroke> strokes_of(const GrayImage& picture) {
  const NetworkImage image = network_image(picture, {.width = 100}, {.measured = true});
  FrameEvidence frame;
  frame.edges = measured_edges(batch_image(image, picture.size));
  const double diagonal = std::hypot(picture.size.width, picture.size.height);
  const auto middles = [&](int count, int pixels) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back((2 * (i + .5) / count - 1) * pixels / diagonal);
    return result;
  };
  frame.centres = {middles(frame.edges.grid.width, picture.size.width),
                   middles(frame.edges.grid.height, picture.size.height)};
  TiltModel none;
  none.tilt.resize(frame.edges.weight.size());
  none.has_tilt.resize(frame.edges.weight.size());
  return edge_strokes(frame, none);
}

}  // namespace

TEST_CASE("a stroke runs through its block along the measured tilt with the model's beside it") {
  BlockPicture picture;
  picture.frame.edges.weighted_tilt[5] = 100 * .2f;      // near-vertical, second row and column
  picture.frame.edges.weighted_tilt[8 + 2] = 100 * .1f;  // near-horizontal, first row and third column
  picture.model.has_tilt[5] = true;
  picture.model.tilt[5] = -.05;
  const std::vector<EdgeStroke> strokes = edge_strokes(picture.frame, picture.model);
  REQUIRE(strokes.size() == 16);

  const EdgeStroke& upright = strokes[5];
  CHECK(upright.family == 0);
  const Vector2d down = upright.measured.to - upright.measured.from;
  CHECK(sine_between(down, {-.2, 1}) == Approx(0).margin(1e-6));
  CHECK(down.y() > 0);
  CHECK(down.x() < 0);  // a positive tilt moves left on its way down
  CHECK(((upright.measured.to + upright.measured.from) / 2 - Vector2d(150, 150)).norm() < 1e-9);
  CHECK(down.norm() < 100);  // stays inside its block
  CHECK(down.norm() > 50);
  REQUIRE(upright.modelled);
  const Vector2d modelled = upright.modelled->to - upright.modelled->from;
  CHECK(sine_between(modelled, {.05, 1}) == Approx(0).margin(1e-6));
  CHECK(modelled.norm() == Approx(down.norm()));
  const double beside = ((upright.modelled->to + upright.modelled->from) / 2 - Vector2d(150, 150)).norm();
  CHECK(beside > 5);
  CHECK(beside < 50);

  const EdgeStroke& level = strokes[8 + 2];
  CHECK(level.family == 1);
  const Vector2d right = level.measured.to - level.measured.from;
  CHECK(sine_between(right, {1, -.1}) == Approx(0).margin(1e-6));
  CHECK(right.x() > 0);
  CHECK(((level.measured.to + level.measured.from) / 2 - Vector2d(250, 50)).norm() < 1e-9);
  CHECK_FALSE(level.modelled);
}

TEST_CASE("strokes are as opaque as the network trusts them") {
  BlockPicture picture;
  picture.frame.edges.weight[3] = 25;   // twice the standard deviation of the others
  picture.frame.edges.weight[4] = .1f;  // some thirty times
  picture.frame.edges.weight[6] = 0;
  const std::vector<EdgeStroke> strokes = edge_strokes(picture.frame, picture.model);
  REQUIRE(strokes.size() == 14);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    CHECK(strokes[i].opacity == Approx(i == 3 ? .5 : 1).epsilon(1e-6));

  for (float& weight : picture.frame.edges.weight) weight = 0;
  CHECK(edge_strokes(picture.frame, picture.model).empty());
}

TEST_CASE("strokes of drawn bars run along the bars") {
  for (double slope : {.12, -.07}) {
    int upright = 0, level = 0;
    for (const EdgeStroke& stroke : strokes_of(leaning_bars({200, 88}, slope))) {
      if (stroke.family != 0 || stroke.opacity < .5) continue;
      CHECK(sine_between(stroke.measured.to - stroke.measured.from, {slope, 1}) == Approx(0).margin(.02));
      ++upright;
    }
    for (const EdgeStroke& stroke : strokes_of(sloping_bars({200, 88}, slope))) {
      if (stroke.family != 1 || stroke.opacity < .5) continue;
      CHECK(sine_between(stroke.measured.to - stroke.measured.from, {1, slope}) == Approx(0).margin(.02));
      ++level;
    }
    CHECK(upright > 100);
    CHECK(level > 100);
  }
}
