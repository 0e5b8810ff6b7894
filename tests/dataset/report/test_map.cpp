#include <catch2/catch.hpp>
#include <numbers>

#include "dataset/report/map.h"
#include "random/counter_hash.h"

using namespace cps;

TEST_CASE("a map shows each place where it is, in its part's colour, with its heading; north is up") {
  const std::set<MapPlace> places = {{Part::train, 100, -50, 0},                     // heads east
                                     {Part::train, 120, -50, std::numbers::pi},      // west
                                     {Part::test, -30, 200, std::numbers::pi / 2}};  // north: to −z
  const PlotFrame frame{.width = 600, .height = 600};
  const Plot map = place_map("town", places, 100, frame);
  REQUIRE(map.series.size() == 4);  // dots of two parts, then headings of both
  CHECK(map.series[0].name == "train");
  CHECK(map.series[0].points == std::vector<Eigen::Vector2d>{{100, 50}, {120, 50}});
  CHECK(map.series[1].name == "test");
  CHECK(map.series[1].points == std::vector<Eigen::Vector2d>{{-30, -200}});
  CHECK(map.series[1].colour == 2);
  const auto ahead = [](const PlotSeries& lines, std::size_t i) -> Eigen::Vector2d {
    return (lines.points[3 * i + 1] - lines.points[3 * i]).normalized();
  };
  CHECK(map.series[2].colour == 0);
  CHECK(ahead(map.series[2], 0).isApprox(Eigen::Vector2d(1, 0)));
  CHECK(ahead(map.series[2], 1).isApprox(Eigen::Vector2d(-1, 0), 1e-9));
  CHECK(ahead(map.series[3], 0).isApprox(Eigen::Vector2d(0, 1), 1e-9));
}

TEST_CASE("of many places a map shows as many as asked, spread over all") {
  std::set<MapPlace> places;
  for (int i = 0; i < 5000; ++i)
    places.insert({Part::train, random_uniform(make_stream(1, "x"), i, 0, 1000),
                   random_uniform(make_stream(1, "z"), i, 0, 1000), 0});
  REQUIRE(places.size() == 5000);
  const Plot map = place_map("town", places, 700, {.width = 600, .height = 600});
  REQUIRE(map.series[0].points.size() == 700);
  int west = 0;
  for (const Eigen::Vector2d& p : map.series[0].points) {
    CHECK(places.contains({Part::train, p.x(), -p.y(), 0}));
    west += p.x() < 500 ? 1 : 0;
  }
  CHECK(std::abs(west - 350) < 30);
}

TEST_CASE("of many scenes the maps with most places are shown") {
  FrameSurvey frames;
  for (int scene = 0; scene < 12; ++scene)
    for (int i = 0; i <= scene; ++i)
      frames.places["city <" + std::to_string(scene) + ">"].insert({Part::val, 10.0 * i, 0, 0});
  CHECK_THAT(maps_html(frames),
             Catch::Contains("8 of 12 scenes") && Catch::Contains("city &lt;11&gt;: 12 places") &&
                 Catch::Contains("city &lt;4&gt;: 5 places") && !Catch::Contains("city &lt;3&gt;"));
}
