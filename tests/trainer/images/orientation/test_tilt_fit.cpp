#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/angles.h"
#include "random/counter_hash.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "trainer/images/orientation/tilt_fit.h"

using namespace cps;

namespace {

const ImageSize picture_size{348, 128}, grid{87, 32};
const double half_diagonal = std::hypot(348, 128) / 2;

TiltFit fit_of(const GrayImage& image, int family) {
  return fit_tilt(edge_cells(view_of(image), grid), family);
}

/// Cells of equal weight whose near-vertical edges have the tilt that the function says.
template <typename Tilt>
EdgeCells cells_with(Tilt tilt) {
  EdgeCells cells{.picture = picture_size, .grid = grid, .families = {}};
  const double weight = 1e6;
  for (int r = 0; r < grid.height; ++r)
    for (int c = 0; c < grid.width; ++c) {
      const double t = tilt(((c + .5) / grid.width - .5) * picture_size.width / half_diagonal,
                            ((r + .5) / grid.height - .5) * picture_size.height / half_diagonal);
      cells.families[0].push_back(
          {std::llround(weight), std::llround(weight * t), std::llround(weight * t * t)});
      cells.energy += 2 * std::llround(weight);
    }
  cells.families[1].resize(pixel_count(grid));
  return cells;
}

constexpr std::array<double, tilt_terms> a_field{.03, -.08, .05, .12, -.04, .1};

double field_at(double x, double y) {
  return a_field[0] + a_field[1] * x + a_field[2] * y + a_field[3] * x * y + a_field[4] * x * x +
         a_field[5] * y * y;
}

}  // namespace

TEST_CASE("the fit finds the field of tilts that it is made of, its share and its residual") {
  const TiltFit fit = fit_tilt(cells_with(field_at), 0);
  for (int i = 0; i < tilt_terms; ++i) CHECK(fit.coefficients[i] == Approx(a_field[i]).margin(2e-3));
  CHECK(fit.residual < 2e-3);
  CHECK(fit.share == Approx(.5).margin(.001));  // whole numbers in the tensors blur the tilts a little
  CHECK(fit_tilt(cells_with(field_at), 1).share == 0);
}

TEST_CASE("standard errors are the deviations of the coefficients") {
  constexpr int draws = 200;
  std::array<double, tilt_terms> squares{};
  for (int draw = 0; draw < draws; ++draw) {
    const Stream stream = make_stream(draw, "tilts");
    std::uint64_t n = 0;
    const TiltFit fit = fit_tilt(
        cells_with([&](double x, double y) { return field_at(x, y) + .05 * random_normal(stream, n++); }), 0);
    CHECK(fit.residual == Approx(.05).epsilon(.1));
    for (int i = 0; i < tilt_terms; ++i)
      squares[i] += std::pow((fit.coefficients[i] - a_field[i]) / fit.errors[i], 2) / draws;
  }
  // The mean of 200 squares of normal numbers has a deviation of .1: four of them, and some for the prior.
  for (double mean : squares) {
    CHECK(mean > .55);
    CHECK(mean < 1.45);
  }
}

TEST_CASE("a picture with one edge says little, and no more") {
  EdgeCells cells = cells_with([](double, double) { return 0; });
  for (EdgeTensor& tensor : cells.families[0]) tensor = {};
  cells.families[0][40] = {1'000'000, 100'000, 10'000};  // a tilt of .1
  const TiltFit fit = fit_tilt(cells, 0);
  for (int i = 0; i < tilt_terms; ++i) {
    CHECK(std::abs(fit.coefficients[i]) < .1);
    CHECK(fit.errors[i] <= .5);
  }
  CHECK(fit.errors[3] > .4);
}

TEST_CASE("straight lines at a known tilt have it as their constant") {
  for (double slope : {-.15, -.05, .02, .1}) {
    for (int family : {0, 1}) {
      const TiltFit fit =
          fit_of(family == 0 ? leaning_bars(picture_size, slope) : sloping_bars(picture_size, slope), family);
      CHECK(fit.coefficients[0] == Approx(-slope).margin(.003));
      for (int i = 1; i < tilt_terms; ++i) CHECK(std::abs(fit.coefficients[i]) < .01);
      CHECK(fit.share > .95);
      CHECK(fit.residual < .01);
    }
  }
}

TEST_CASE(
    "lines that converge, as under a pitched camera, tilt in proportion to their distance from the middle") {
  for (double a : {.1, -.15}) {
    // x / (1 + a Y) is constant along a line, so its tilt is −a X / (1 + a Y).
    const TiltFit fit = fit_of(
        drawn(picture_size,
              [=](double x, double y) { return 128 + 100 * std::sin(x / (1 + a * y / half_diagonal) / 2); }),
        0);
    CHECK(fit.coefficients[1] == Approx(-a).epsilon(.03));
    CHECK(fit.coefficients[3] == Approx(a * a).margin(.01));
    CHECK(std::abs(fit.coefficients[0]) < .003);
  }
}

TEST_CASE("the coefficient of XY follows the radial distortion, and has the opposite sign") {
  const auto xy_of = [](double K1) {  // K1: at the half diagonal, see TargetSpace::apparent
    CalibratedCamera camera{"", pinhole_from_hfov(picture_size.width, picture_size.height, radians(60)), {}};
    const double r = half_diagonal / camera.pinhole.fx;
    camera.distortion.k1 = K1 / (r * r);
    const GrayImage wall = wall_grid(camera);
    std::array<double, edge_families> xy;
    for (int family = 0; family < edge_families; ++family) {
      const TiltFit fit = fit_of(wall, family);
      xy[family] = fit.coefficients[3];
      for (int i : {0, 1, 2, 4, 5}) CHECK(std::abs(fit.coefficients[i]) < .03);
    }
    return xy;
  };
  std::array<double, edge_families> before{1, 1};
  for (double K1 : {-.1, -.05, 0., .05, .1}) {
    INFO("K1 " << K1);
    const auto xy = xy_of(K1);
    for (int family = 0; family < edge_families; ++family) {
      CHECK(xy[family] == Approx(-2 * K1).margin(.01 + .8 * std::abs(K1)));  // to first order
      CHECK(xy[family] < before[family] - .02);
    }
    before = xy;
  }
}
