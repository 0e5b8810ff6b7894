#include <catch2/catch.hpp>
#include <cmath>
#include <pugixml.hpp>

#include "files/plot.h"
#include "random/counter_hash.h"

using namespace cps;

TEST_CASE("ticks are round and cover the range") {
  CHECK(round_ticks({0, 1}, 5) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
  CHECK(round_ticks({-0.33, 0.2}, 5) == std::vector<double>{-0.2, 0, 0.2});
  CHECK(round_ticks({30, 150}, 6) == std::vector<double>{40, 60, 80, 100, 120, 140});
  for (int i = 0; i < 1000; ++i) {
    const Stream stream = substream(make_stream(1, "ticks"), i);
    const double low = random_uniform(stream, 0, -1, 1),
                 size = std::pow(10, random_uniform(stream, 1, -6, 6));
    const auto ticks = round_ticks({low * size, (low + 1) * size}, 6);
    CHECK(ticks.size() >= 2);
    CHECK(ticks.size() <= 7);
    CHECK(ticks.front() >= low * size - 1e-6 * size);
    CHECK(ticks.back() <= (low + 1) * size + 1e-6 * size);
  }
}

TEST_CASE("a histogram's area is the share of the values that it shows") {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(random_uniform(make_stream(2, "values"), i, -1, 3));
  const PlotSeries outline = histogram("", values, {0, 2}, 16);
  double area = 0;
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i)
    area += outline.points[i].y() * (outline.points[i + 1].x() - outline.points[i].x());
  const auto shown = std::count_if(values.begin(), values.end(), [](double v) { return v >= 0 && v < 2; });
  CHECK(area == Approx(shown / 1000.0));
}

TEST_CASE("a page of diagrams is XML with a curve for each series, whatever its words and numbers") {
  const double none = NAN;
  const std::vector<Plot> plots = {
      {.title = "a < b & c",
       .x_label = "H-FOV [°]",
       .y_label = "k1",
       .series = {{.name = "low", .points = {{0, 1}, {1, none}, {2, 3}, {3, 4}}},
                  {.name = "dots", .style = PlotStyle::dots, .points = {{0, 0}, {1, 99}, {2, 2}}}},
       .x_range = {},
       .y_range = Interval{0, 10}},
      {.title = "", .x_label = "", .y_label = "", .series = {}, .x_range = {}, .y_range = {}}};
  pugi::xml_document page;
  REQUIRE(page.load_string(to_svg(plots, 2).c_str()));
  const auto diagrams = page.child("svg").children("g");
  REQUIRE(std::distance(diagrams.begin(), diagrams.end()) == 2);
  const pugi::xml_node first = *diagrams.begin();
  CHECK(first.find_child_by_attribute("text", "font-weight", "bold").child_value() ==
        std::string("a < b & c"));
  const pugi::xml_node line = first.find_child_by_attribute("path", "clip-path", "url(#frame)");
  // A point at the left edge, a gap, then a piece to the right edge; y = 1 … 4 of 10 on 226 units.
  CHECK(line.attribute("d").value() == std::string("M62.0 233.4M291.3 188.2L406.0 165.6"));
  const pugi::xml_node dots = first.find_child_by_attribute("path", "stroke-linecap", "round");
  CHECK(dots.attribute("d").value() == std::string("M62.0 256.0h0M291.3 210.8h0"));
}
