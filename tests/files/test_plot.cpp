#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "files/plot.h"
#include "random/counter_hash.h"

using namespace cps;

namespace {

/// The text elements of a diagram that read as numbers: the labels of its ticks.
std::vector<std::pair<double, pugi::xml_node>> tick_labels(const pugi::xml_node& diagram,
                                                           const char* anchor) {
  std::vector<std::pair<double, pugi::xml_node>> labels;
  for (const pugi::xml_node& text : diagram.children("text")) {
    char* end = nullptr;
    const double value = std::strtod(text.child_value(), &end);
    if (*text.child_value() && *end == 0 && text.attribute("text-anchor").value() == std::string(anchor))
      labels.emplace_back(value, text);
  }
  return labels;
}

/// The line through the first and the last label: from page to value along one axis.
struct PageAxis {
  double value, page, per_page;
  double value_at(double x) const { return value + (x - page) * per_page; }
};

PageAxis axis_of(const pugi::xml_node& diagram, const char* anchor, const char* attribute) {
  const auto labels = tick_labels(diagram, anchor);
  REQUIRE(labels.size() >= 2);
  const auto page = [&](const auto& label) { return label.second.attribute(attribute).as_double(); };
  const PageAxis axis{
      labels.front().first, page(labels.front()),
      (labels.back().first - labels.front().first) / (page(labels.back()) - page(labels.front()))};
  for (const auto& label : labels)  // positions are rounded to a tenth
    CHECK(std::abs(axis.value_at(page(label)) - label.first) <= .21 * std::abs(axis.per_page));
  return axis;
}

/// The points of an SVG path, with the letter that led to each.
std::vector<std::pair<char, Eigen::Vector2d>> path_points(const pugi::xml_node& path) {
  std::vector<std::pair<char, Eigen::Vector2d>> points;
  std::istringstream text(path.attribute("d").value());
  char letter = 0;
  while (text >> letter) {
    double x = 0, y = 0;
    text >> x;
    if (letter == 'h') continue;  // a dot: a line of no length
    REQUIRE((letter == 'M' || letter == 'L'));
    text >> y;
    points.emplace_back(letter, Eigen::Vector2d(x, y));
  }
  return points;
}

}  // namespace

TEST_CASE("ticks are all multiples of a round step inside the range") {
  for (int i = 0; i < 1000; ++i) {
    const Stream stream = substream(make_stream(1, "ticks"), i);
    const double size = std::pow(10, random_uniform(stream, 1, -6, 6)),
                 low = size * random_uniform(stream, 0, -1, 1), high = low + size;
    const auto ticks = round_ticks({low, high}, 6);
    REQUIRE(ticks.size() >= 2);
    CHECK(ticks.size() <= 7);
    // One step of 1, 2 or 5 times a power of ten, and a multiple of it inside the range at each tick.
    const double step = ticks[1] - ticks[0], power = std::pow(10, std::floor(std::log10(step) + 1e-6)),
                 digit = step / power;
    CHECK((std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6));
    for (std::size_t t = 0; t < ticks.size(); ++t) {
      CHECK(std::abs(ticks[t] / step - std::round(ticks[t] / step)) < 1e-6);
      CHECK(ticks[t] == Approx(ticks[0] + static_cast<double>(t) * step).margin(1e-6 * step));
    }
    // None is missing at either end.
    CHECK(ticks.front() >= low - 1e-6 * step);
    CHECK(ticks.front() - step < low + 1e-6 * step);
    CHECK(ticks.back() <= high + 1e-6 * step);
    CHECK(ticks.back() + step > high - 1e-6 * step);
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

TEST_CASE("curves and dots lie where the axes say, and a point that is not finite interrupts a line") {
  const std::vector<Eigen::Vector2d> line = {{30, -.2}, {55, .1}, {70, NAN}, {100, .31}, {149, .4}},
                                     dots = {{40, 0}, {60, 99}, {80, .25}};
  const Plot plot{.title = "",
                  .x_label = "",
                  .y_label = "",
                  .series = {{.name = "line", .points = line},
                             {.name = "dots", .style = PlotStyle::dots, .points = dots}},
                  .x_range = {},
                  .y_range = Interval{-.5, .5}};
  pugi::xml_document page;
  REQUIRE(page.load_string(to_svg({&plot, 1}, 1).c_str()));
  const pugi::xml_node diagram = page.child("svg").child("g");
  const PageAxis x = axis_of(diagram, "middle", "x"), y = axis_of(diagram, "end", "y");
  CHECK(y.per_page < 0);  // upward
  // Labels of y stand a little below their line, to be level with it: the frame says where the lines are.
  const pugi::xml_node frame = diagram.child("rect");
  const double top = frame.attribute("y").as_double(), bottom = top + frame.attribute("height").as_double();
  const auto at = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(x.value_at(p.x()), -.5 + (bottom - p.y()) / (bottom - top));
  };
  // Positions are rounded to a tenth, those of the labels too.
  const Eigen::Vector2d rounding(.2 * std::abs(x.per_page), .06 * std::abs(y.per_page));
  const auto check_at = [&](const Eigen::Vector2d& drawn, const Eigen::Vector2d& expected) {
    INFO(expected.transpose());
    CHECK(((at(drawn) - expected).cwiseAbs().array() <= rounding.array()).all());
  };
  const auto curve = path_points(diagram.find_child_by_attribute("path", "clip-path", "url(#frame)"));
  REQUIRE(curve.size() == 4);
  const std::string letters = {curve[0].first, curve[1].first, curve[2].first, curve[3].first};
  CHECK(letters == "MLML");
  const std::size_t finite[] = {0, 1, 3, 4};
  for (int i = 0; i < 4; ++i) check_at(curve[i].second, line[finite[i]]);
  // The dot outside the range of y is left out.
  const auto drawn = path_points(diagram.find_child_by_attribute("path", "stroke-linecap", "round"));
  REQUIRE(drawn.size() == 2);
  check_at(drawn[0].second, dots[0]);
  check_at(drawn[1].second, dots[2]);
  // Ticks of y stand at their lines.
  for (const auto& [value, label] : tick_labels(diagram, "end"))
    CHECK(std::abs(at({0, label.attribute("y").as_double()}).y() - value) < 6 * std::abs(y.per_page));
}

TEST_CASE("bars join the points of pairs alone and fade as asked") {
  const Plot plot{
      .title = "",
      .x_label = "",
      .y_label = "",
      .series = {{.style = PlotStyle::bars,
                  .points = {{1, 2}, {1, 4}, {2, 3}, {2, 5}, {3, -INFINITY}, {3, 1}, {4, 0}, {4, 1}},
                  .opacity = .25}}};
  pugi::xml_document page;
  REQUIRE(page.load_string(to_svg({&plot, 1}, 1).c_str()));
  const pugi::xml_node bars =
      page.child("svg").child("g").find_child_by_attribute("path", "clip-path", "url(#frame)");
  CHECK(bars.attribute("stroke-opacity").as_double() == .25);
  const auto points = path_points(bars);
  std::string letters;
  for (const auto& [letter, point] : points) letters += letter;
  CHECK(letters == "MLMLMML");  // the point whose partner is not finite stands alone and shows nothing
  REQUIRE(points.size() == 7);
  for (std::size_t first : {0, 2, 5}) {
    CHECK(points[first].second.x() == points[first + 1].second.x());
    CHECK(points[first].second.y() > points[first + 1].second.y());  // upward
  }
}

TEST_CASE("a legend below stands in the lower half of the diagram with all its names inside") {
  Plot plot{
      .title = "",
      .x_label = "",
      .y_label = "",
      .series = {{.name = "first", .points = {{0, 0}, {1, 1}}}, {.name = "second", .points = {{0, 0}}}}};
  for (bool is_below : {false, true}) {
    plot.has_legend_below = is_below;
    pugi::xml_document page;
    REQUIRE(page.load_string(to_svg({&plot, 1}, 1).c_str()));
    const pugi::xml_node diagram = page.child("svg").child("g"), frame = diagram.child("rect");
    const double top = frame.attribute("y").as_double(), bottom = top + frame.attribute("height").as_double(),
                 middle = (top + bottom) / 2;
    int names = 0;
    for (const pugi::xml_node& text : diagram.children("text")) {
      const std::string name = text.child_value();
      if (name != "first" && name != "second") continue;
      const double y = text.attribute("y").as_double();
      CHECK((is_below ? y > middle && y < bottom : y > top && y < middle));
      ++names;
    }
    CHECK(names == 2);
  }
}

TEST_CASE("a page holds each plot's diagram in a grid, with its texts escaped") {
  const std::vector<Plot> plots = {
      {.title = "a < b & \"c\" > d",
       .x_label = "H-FOV [°]",
       .y_label = "k1",
       .series = {},
       .x_range = {},
       .y_range = {}},
      {.title = "",
       .x_label = "",
       .y_label = "",
       .series = {{.name = "<k1>", .points = {{3, 4}}}},
       .x_range = {},
       .y_range = {}},
      {.title = "third", .x_label = "", .y_label = "", .series = {}, .x_range = {}, .y_range = {}}};
  pugi::xml_document page;
  REQUIRE(page.load_string(to_svg(plots, 2).c_str()));
  const pugi::xml_node svg = page.child("svg");
  const std::vector<pugi::xml_node> diagrams(svg.children("g").begin(), svg.children("g").end());
  REQUIRE(diagrams.size() == 3);
  const auto has_text = [](const pugi::xml_node& diagram, const std::string& words) {
    const auto texts = diagram.children("text");
    return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.child_value() == words; });
  };
  for (const std::string& words : {plots[0].title, plots[0].x_label, plots[0].y_label})
    CHECK(has_text(diagrams[0], words));
  CHECK(has_text(diagrams[1], "<k1>"));
  CHECK(has_text(diagrams[2], "third"));
  // Two columns: the second beside the first, the third below it; all on the page.
  std::vector<Eigen::Vector2d> corners;
  for (const pugi::xml_node& diagram : diagrams) {
    double column = -1, row = -1;
    REQUIRE(std::sscanf(diagram.attribute("transform").value(), "translate(%lf %lf)", &column, &row) == 2);
    corners.emplace_back(column, row);
  }
  const Eigen::Vector2d size(svg.attribute("width").as_double(), svg.attribute("height").as_double());
  CHECK(corners[0] == Eigen::Vector2d(0, 0));
  CHECK(corners[1] == Eigen::Vector2d(size.x() / 2, 0));
  CHECK(corners[2] == Eigen::Vector2d(0, size.y() / 2));
  const pugi::xml_node frame = diagrams[0].child("rect");
  CHECK(frame.attribute("x").as_double() + frame.attribute("width").as_double() < size.x() / 2);
  CHECK(frame.attribute("y").as_double() + frame.attribute("height").as_double() < size.y() / 2);
}

TEST_CASE(
    "a map's scales are equal, all its points lie on it, and its frame has the size and name asked for") {
  for (const std::vector<Eigen::Vector2d>& points :
       {std::vector<Eigen::Vector2d>{{-300, 10}, {500, 40}}, {{3, -900}, {4, 900}}, {{7, 7}}}) {
    Plot map{
        .title = "", .x_label = "", .y_label = "", .series = {{.name = "", .points = points, .colour = 2}}};
    const PlotFrame frame{.width = 500, .height = 640, .clip = "town"};
    make_scales_equal(map, frame);
    for (const Eigen::Vector2d& p : points) {
      CHECK((p.x() >= map.x_range->low && p.x() <= map.x_range->high));
      CHECK((p.y() >= map.y_range->low && p.y() <= map.y_range->high));
    }
    pugi::xml_document page;
    REQUIRE(page.load_string(to_svg({&map, 1}, 1, frame).c_str()));
    const pugi::xml_node svg = page.child("svg"), diagram = svg.child("g"), inside = diagram.child("rect");
    CHECK(svg.attribute("width").as_int() == 500);
    CHECK(svg.attribute("height").as_int() == 640);
    CHECK(inside.attribute("width").as_double() / (map.x_range->high - map.x_range->low) ==
          Approx(inside.attribute("height").as_double() / (map.y_range->high - map.y_range->low)));
    CHECK(svg.child("clipPath").attribute("id").value() == std::string("town"));
    const pugi::xml_node curve = diagram.find_child_by_attribute("path", "clip-path", "url(#town)");
    CHECK(curve.attribute("stroke").value() == std::string("#009e73"));  // the third colour
  }
}
