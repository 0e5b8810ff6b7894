#include <fmt/format.h>

#include "dataset/report/map.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"
#include "files/markup.h"

namespace cps {
namespace {

std::string rejected(const Description::Places& places) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [reason, number] : places.rejected_for)
    rows.push_back({escaped(reason), grouped(number), percent(number, places.drawn)});
  return fmt::format(
             "<h3>Rejected places</h3>\n<p>{} places were drawn, {} of them rejected ({}) and drawn "
             "again.</p>\n",
             grouped(places.drawn), grouped(places.rejected), percent(places.rejected, places.drawn)) +
         html_table({"reason", "places", "of all drawn"}, rows);
}

}  // namespace

std::string place_section(const DatasetSurvey& survey) {
  if (!survey.frames) return "";
  std::string html =
      "<section id=\"places\"><h2>Places</h2>\n<p>Where the car stood, from above, north up. A line points "
      "where it headed.</p>\n" +
      maps_html(*survey.frames);
  if (survey.description->places) html += rejected(*survey.description->places);
  return html + "</section>\n";
}

}  // namespace cps
