#include "dataset/report/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/report/text.h"
#include "files/markup.h"

namespace cps {
namespace {

constexpr std::size_t max_maps = 8, max_places_shown = 3000;
constexpr double heading_length = 9;  ///< of a heading's line, in SVG user units

std::size_t part_index(const MapPlace& place) {
  return static_cast<std::size_t>(place.part);
}

/// On the map: east to the right, north up.
Eigen::Vector2d on_map(const MapPlace& place) {
  return {place.x_m, -place.z_m};
}

/// Every place, or `count` of them: in the order by part and position, so that all are shown alike.
std::vector<const MapPlace*> evenly_chosen(const std::set<MapPlace>& places, std::size_t count) {
  std::vector<const MapPlace*> chosen;
  std::size_t i = 0;
  for (const MapPlace& place : places) {
    if (places.size() <= count || i * count % places.size() < count) chosen.push_back(&place);
    ++i;
  }
  return chosen;
}

}  // namespace

Plot place_map(const std::string& title, const std::set<MapPlace>& places, std::size_t max_places,
               const PlotFrame& frame) {
  Plot map{.title = title, .x_label = "east, m", .y_label = "north, m"};
  std::array<PlotSeries, 3> dots, headings;
  const std::vector<const MapPlace*> shown = evenly_chosen(places, max_places);
  for (const MapPlace* place : shown) dots[part_index(*place)].points.push_back(on_map(*place));
  for (std::size_t p = 0; p < 3; ++p) {
    if (dots[p].points.empty()) continue;
    dots[p].name = to_string(static_cast<Part>(p));
    dots[p].style = PlotStyle::dots;
    dots[p].colour = p;
    map.series.push_back(std::move(dots[p]));
  }
  make_scales_equal(map, frame);
  const double length_m = heading_length * (map.x_range->high - map.x_range->low) / frame.width;
  for (const MapPlace* place : shown) {
    const Eigen::Vector2d from = on_map(*place),
                          ahead(std::cos(place->heading_rad), std::sin(place->heading_rad));
    std::vector<Eigen::Vector2d>& line = headings[part_index(*place)].points;
    line.insert(line.end(), {from, from + length_m * ahead, {NAN, NAN}});
  }
  for (std::size_t p = 0; p < 3; ++p) {
    headings[p].colour = p;
    if (!headings[p].points.empty()) map.series.push_back(std::move(headings[p]));
  }
  return map;
}

std::string maps_html(const FrameSurvey& frames) {
  std::vector<const std::pair<const std::string, std::set<MapPlace>>*> maps;
  for (const auto& map : frames.places) maps.push_back(&map);
  std::ranges::stable_sort(maps,
                           [](const auto* a, const auto* b) { return a->second.size() > b->second.size(); });
  std::string html;
  if (maps.size() > max_maps)
    html += fmt::format("<p>{} of {} scenes, those with most places.</p>\n", max_maps, maps.size());
  html += "<div class=\"maps\">\n";
  for (std::size_t i = 0; i < std::min(max_maps, maps.size()); ++i) {
    const auto& [name, places] = *maps[i];
    const PlotFrame frame{.width = 620, .height = 620, .clip = fmt::format("map{}", i)};
    const Plot map = place_map(name, places, max_places_shown, frame);
    const std::string shown =
        places.size() > max_places_shown ? ", " + grouped(max_places_shown) + " of them shown" : "";
    html += fmt::format("<figure>{}<figcaption>{}: {} places{}</figcaption></figure>\n",
                        to_svg({&map, 1}, 1, frame), escaped(name), grouped(std::ssize(places)), shown);
  }
  return html + "</div>\n";
}

}  // namespace cps
