#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "random/counter_hash.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "tests/trainer/street.h"
#include "trainer/images/orientation/edge_cells.h"
#include "trainer/images/orientation/measure.h"

using namespace cps;

namespace {

const ImageSize picture{348, 128}, network{174, 64};

GrayImage noise(const ImageSize& size) {
  const Stream stream = make_stream(1, "noise");
  GrayImage image{size, {}};
  for (std::size_t i = 0; i < pixel_count(size); ++i)
    image.pixels.push_back(static_cast<std::uint8_t>(random_bits(stream, i)));
  return image;
}

GrayImage street() {
  return render_street(draw_calibration(picture, 70, 3), 5);
}

}  // namespace

TEST_CASE("the tilt of straight bars is minus their slope in every cell") {
  const Orientation flat = orientation_of(view_of(leaning_bars(picture, 0)), network);
  REQUIRE(flat.grid == ImageSize{87, 32});
  const std::size_t cells = 87 * 32;
  for (std::size_t i = 0; i < cells; ++i) {
    CHECK(flat.planes[i] == 0);
    CHECK(flat.planes[3 * cells + i] == 0);  // no confidence in near-horizontal edges
  }
  for (double slope : {-.2, -.1, -.02, .05, .15})
    for (int family : {0, 1}) {
      const GrayImage bars = family == 0 ? leaning_bars(picture, slope) : sloping_bars(picture, slope);
      const Orientation measured = orientation_of(view_of(bars), network);
      int seen = 0;
      for (std::size_t i = 0; i < cells; ++i) {
        const double confidence = measured.planes[(2 + family) * cells + i] / confidence_steps_per_unit;
        CHECK(measured.planes[(3 - family) * cells + i] == 0);
        CHECK(confidence < .85);
        if (confidence < .3) continue;
        ++seen;
        CHECK(measured.planes[family * cells + i] / tilt_steps_per_unit == Approx(-slope).margin(.008));
      }
      CHECK(seen > .95 * static_cast<double>(cells));
    }
}

TEST_CASE("edges that lie in all directions have less confidence than edges that agree") {
  // Tilts of ±.1 in equal shares have a deviation of .1: they count 1 / (1 + (.1 / .03)²) = 9 / 109.
  CHECK(coherence({1'000'000, 0, 10'000}) == Approx(9. / 109));
  CHECK(coherence({1'000'000, 100'000, 10'000}) == Approx(1));
  CHECK(coherence({}) == 1);

  // Bars that lean to the left and to the right by turns, six pixels high; a cell holds both.
  const GrayImage agreeing = leaning_bars(picture, .1);
  const GrayImage scattered = drawn(picture, [](double x, double y) {
    const double turn = std::abs(std::remainder(y, 12));
    return 128 + 100 * std::sin((x - .2 * turn) * 2 * std::numbers::pi / 12);
  });
  const auto mean_confidence = [](const GrayImage& image) {
    const Orientation measured = orientation_of(view_of(image), {58, 22});  // cells of 12 pixels
    const std::size_t cells = pixel_count(measured.grid);
    double sum = 0;
    for (std::size_t i = 0; i < cells; ++i) sum += measured.planes[2 * cells + i];
    return sum / (static_cast<double>(cells) * confidence_steps_per_unit);
  };
  CHECK(mean_confidence(agreeing) > .65);
  CHECK(mean_confidence(scattered) < .35);
}

TEST_CASE("contrast and brightness change no bit, a flat picture has no edges") {
  GrayImage dark = street(), bright = dark;
  for (std::uint8_t& pixel : dark.pixels) pixel /= 4;
  for (std::size_t i = 0; i < dark.pixels.size(); ++i)
    bright.pixels[i] = static_cast<std::uint8_t>(4 * dark.pixels[i] + 3);
  const Orientation a = orientation_of(view_of(dark), network), b = orientation_of(view_of(bright), network);
  CHECK(a.planes == b.planes);
  CHECK(a.numbers == b.numbers);

  const Orientation none = orientation_of(
      view_of(GrayImage{picture, std::vector<std::uint8_t>(pixel_count(picture), 90)}), network);
  for (std::int8_t step : none.planes) CHECK(step == 0);
  for (int i = 0; i < orientation_number_count; ++i) {
    const bool is_error = orientation_number_names[i].find("_error_") != std::string::npos;
    CHECK(none.numbers[i] == (is_error ? .5f : 0.f));
  }
}

TEST_CASE("sums over cells are those of a plain loop, also where cells and pixels do not match") {
  for (const auto& sizes :
       {std::pair{ImageSize{61, 37}, ImageSize{24, 15}}, std::pair{ImageSize{300, 9}, ImageSize{2, 3}},
        std::pair{ImageSize{8, 8}, ImageSize{5, 5}}}) {
    const ImageSize size = sizes.first, grid = sizes.second;
    const GrayImage image = noise(size);
    const auto at = [&](int x, int y) { return static_cast<std::int64_t>(image.pixels[y * size.width + x]); };
    EdgeCells expected{.picture = size, .grid = grid, .families = {}};
    for (auto& family : expected.families) family.resize(pixel_count(grid));
    for (int y = 1; y < size.height - 1; ++y)
      for (int x = 1; x < size.width - 1; ++x) {
        std::int64_t gx = 0, gy = 0;
        for (int d : {-1, 0, 1}) {
          const int weight = d == 0 ? 10 : 3;
          gx += weight * (at(x + 1, y + d) - at(x - 1, y + d));
          gy += weight * (at(x + d, y + 1) - at(x + d, y - 1));
        }
        expected.energy += gx * gx + gy * gy;
        const int column = static_cast<int>(std::floor((x + .5) * grid.width / size.width)),
                  row = static_cast<int>(std::floor((y + .5) * grid.height / size.height));
        const int cell = row * grid.width + column;
        if (std::abs(gx) > 4 * std::abs(gy)) {
          EdgeTensor& tensor = expected.families[0][cell];
          tensor.steep += gx * gx, tensor.product += gx * gy, tensor.flat += gy * gy;
        }
        if (std::abs(gy) > 4 * std::abs(gx)) {
          EdgeTensor& tensor = expected.families[1][cell];
          tensor.steep += gy * gy, tensor.product += gx * gy, tensor.flat += gx * gx;
        }
      }
    const EdgeCells cells = edge_cells(view_of(image), grid);
    CHECK(cells.energy == expected.energy);
    for (int family : {0, 1})
      for (std::size_t i = 0; i < pixel_count(grid); ++i) {
        const EdgeTensor &a = cells.families[family][i], &b = expected.families[family][i];
        CHECK((a.steep == b.steep && a.product == b.product && a.flat == b.flat));
      }
  }
}

TEST_CASE("the steepest picture does not overflow") {
  GrayImage edge{{640, 9}, std::vector<std::uint8_t>(640 * 9, 0)};
  for (std::size_t i = 0; i < edge.pixels.size(); ++i) edge.pixels[i] = i / 2 % 2 == 0 ? 0 : 255;
  const EdgeCells cells = edge_cells(view_of(edge), {1, 1});
  CHECK(cells.families[0][0].steep == std::int64_t{4080} * 4080 * 638 * 7);
  CHECK(cells.energy == cells.families[0][0].steep);
}

TEST_CASE("the flipped picture has flipped planes, opposite tilts and mirrored numbers") {
  const GrayImage image = street();
  const Orientation seen = orientation_of(view_of(image), network),
                    other = orientation_of(view_of(flipped(image)), network);
  const auto [columns, rows] = seen.grid;
  for (int plane = 0; plane < orientation_plane_count; ++plane)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const int first = (plane * rows + y) * columns;
        const int sign = plane < edge_families ? -1 : 1;
        CHECK(other.planes[first + x] == sign * seen.planes[first + columns - 1 - x]);
      }
  const OrientationNumbers expected = mirrored(seen.numbers);
  for (int i = 0; i < orientation_number_count; ++i) {
    INFO(orientation_number_names[i]);
    CHECK(other.numbers[i] == Approx(expected[i]).epsilon(1e-4).margin(1e-5));
  }
  CHECK(mirrored(expected) == seen.numbers);
  CHECK(expected != seen.numbers);
}

TEST_CASE("a wide picture is reduced before it is measured, but never below the network's image") {
  const GrayImage image = leaning_bars({400, 120}, .1);
  CHECK(measured_picture(image, {100, 30}, 1392).pixels == image.pixels);
  CHECK(measured_picture(image, {100, 30}, 200).size == ImageSize{200, 60});
  CHECK(measured_picture(image, {300, 90}, 200).size == ImageSize{300, 90});
}
