#include <catch2/catch.hpp>

#include "dataset/report/distribution.h"

using namespace cps;

namespace {

/// 30 values of train at 0.25 and 10 at 0.8, two of val, one of them beyond the limits.
Distribution example() {
  Distribution distribution{.name = "k1", .unit = "", .limits = Interval{0, 1}};
  for (int i = 0; i < 30; ++i) distribution.add(Part::train, 0.25);
  for (int i = 0; i < 10; ++i) distribution.add(Part::train, 0.8);
  distribution.add(Part::val, 0.5);
  distribution.add(Part::val, 1.5);
  return distribution;
}

/// Height of an outline at x.
double height_at(const PlotSeries& outline, double x) {
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i)
    if (outline.points[i].x() <= x && x < outline.points[i + 1].x()) return outline.points[i + 1].y();
  return 0;
}

}  // namespace

TEST_CASE("a distribution's summary has its moments, and counts what lies outside its limits") {
  const DistributionSummary summary = summary_of(example());
  CHECK(summary.count == 42);
  CHECK(summary.min == 0.25);
  CHECK(summary.max == 1.5);
  const double mean = (30 * 0.25 + 10 * 0.8 + 0.5 + 1.5) / 42;
  CHECK(summary.mean == Approx(mean));
  const double squares = 30 * std::pow(0.25 - mean, 2) + 10 * std::pow(0.8 - mean, 2) +
                         std::pow(0.5 - mean, 2) + std::pow(1.5 - mean, 2);
  CHECK(summary.standard_deviation == Approx(std::sqrt(squares / 42)));
  CHECK(summary.outside == 1);
  Distribution at_the_end{.name = "k1", .unit = "", .limits = Interval{0.1, 0.3}};
  at_the_end.add(Part::test, 0.1 + 0.2);  // the limit but for rounding
  CHECK(summary_of(at_the_end).outside == 0);
}

TEST_CASE("the histograms are shares of each part's images, beside lines at the limits") {
  const Plot plot = distribution_plot(example());
  REQUIRE(plot.series.size() == 3);
  CHECK(plot.series[0].name == "train");
  CHECK(height_at(plot.series[0], 0.25) == Approx(75));
  CHECK(height_at(plot.series[0], 0.8) == Approx(25));
  CHECK(height_at(plot.series[0], 0.5) == 0);
  CHECK(plot.series[1].name == "val");
  CHECK(height_at(plot.series[1], 0.5) == Approx(50));
  CHECK(height_at(plot.series[1], 1.5) == Approx(50));
  CHECK(plot.series[2].name == "limits");
  CHECK(plot.series[2].points.front().x() == 0);
  CHECK(plot.series[2].points.back().x() == 1);
  CHECK(plot.x_range->low < 0);
  CHECK(plot.x_range->high > 1.5);
  CHECK(plot.y_range->high > 75);
}

TEST_CASE("a distribution's caption names count, limits and note; one without values is left out") {
  Distribution distribution = example();
  distribution.name = "k1 <\"&>";
  distribution.note = "drawn <from>";
  CHECK_THAT(to_html(distribution, 7),
             Catch::Contains("42 images: 0.25 … 1.5") && Catch::Contains("limits 0 … 1; 1 outside") &&
                 Catch::Contains("drawn &lt;from&gt;") && Catch::Contains("k1 &lt;&quot;&amp;&gt;") &&
                 Catch::Contains("id=\"frame7\""));
  CHECK(to_html(Distribution{.name = "k1", .unit = ""}, 0).empty());
  // All values alike.
  Distribution constant{.name = "cx", .unit = "px"};
  constant.add(Part::test, 240);
  CHECK_THAT(to_html(constant, 0), Catch::Contains("1 images: 240 … 240"));
}
