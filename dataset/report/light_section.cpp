#include <fmt/format.h>

#include <cmath>
#include <map>

#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"
#include "files/markup.h"
#include "files/plot.h"

namespace cps {
namespace {

constexpr std::size_t max_conditions = 200, max_suns = 3000;

struct WeatherTally {
  std::int64_t conditions = 0, images = 0;
  std::vector<Eigen::Vector2d> suns;  ///< azimuth and elevation, degrees
};

/// The recipe's share of a weather, as text.
std::string recipe_share(const LightOptions& light, const std::string& weather) {
  if (weather == to_string(Weather::clear)) return fmt::format("{:.4g} %", 100 * light.clear_share);
  if (weather == to_string(Weather::hazy)) return fmt::format("{:.4g} %", 100 * light.hazy_share);
  return fmt::format("{:.4g} %", 100 * (1 - light.clear_share - light.hazy_share));
}

std::string weather_table(const std::map<std::string, WeatherTally>& weathers, const LightOptions& light,
                          std::int64_t conditions, std::int64_t images) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [weather, tally] : weathers)
    rows.push_back({escaped(weather), grouped(tally.conditions), percent(tally.conditions, conditions),
                    recipe_share(light, weather), grouped(tally.images), percent(tally.images, images)});
  return html_table({"weather", "conditions", "share", "recipe", "images", "share"}, rows);
}

Plot sun_plot(std::map<std::string, WeatherTally>& weathers, const LightOptions& light) {
  Plot plot{.title = "Suns",
            .x_label = "azimuth, degrees clockwise from north",
            .y_label = "elevation, degrees",
            .x_range = Interval{0, 360},
            .y_range = Interval{0, 90}};
  std::size_t colour = 0;
  for (auto& [weather, tally] : weathers) {
    tally.suns.resize(std::min(tally.suns.size(), max_suns));
    plot.series.push_back(
        {.name = weather, .style = PlotStyle::dots, .points = tally.suns, .colour = colour++ % 4});
  }
  plot.series.push_back({.name = "limits",
                         .points = {{0, light.sun_elevation_min_deg},
                                    {360, light.sun_elevation_min_deg},
                                    {NAN, NAN},
                                    {0, light.sun_elevation_max_deg},
                                    {360, light.sun_elevation_max_deg}},
                         .colour = 6});
  return plot;
}

std::string condition_table(const DatasetSurvey& survey) {
  const std::vector<Description::Condition>& conditions = survey.description->conditions;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t c = 0; c < std::min(conditions.size(), max_conditions); ++c) {
    const Description::Condition& at = conditions[c];
    rows.push_back({std::to_string(c), clipped(at.scene, 100), clipped(at.date + " " + at.time_utc, 40),
                    clipped(at.weather, 40), fmt::format("{:.1f}°", at.sun_elevation_deg),
                    fmt::format("{:.1f}°", at.sun_azimuth_deg), fmt::format("{:.2f}", at.turbidity),
                    grouped(survey.frames->images_of_condition[c])});
  }
  std::string html = "<h3>Conditions</h3>\n";
  if (conditions.size() > max_conditions)
    html += fmt::format("<p>The first {} of {}.</p>\n", max_conditions,
                        grouped(static_cast<std::int64_t>(conditions.size())));
  return html + html_table({"", "scene", "date and time (UTC)", "weather", "sun's elevation", "azimuth",
                            "turbidity", "images"},
                           rows);
}

}  // namespace

std::string light_section(const DatasetSurvey& survey) {
  if (!survey.frames) return "";
  const LightOptions& light = survey.recipe->light;
  const std::vector<Description::Condition>& conditions = survey.description->conditions;
  std::map<std::string, WeatherTally> weathers;
  std::int64_t images = 0;
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    WeatherTally& tally = weathers[conditions[c].weather.substr(0, 40)];
    ++tally.conditions;
    tally.images += survey.frames->images_of_condition[c];
    tally.suns.emplace_back(conditions[c].sun_azimuth_deg, conditions[c].sun_elevation_deg);
    images += survey.frames->images_of_condition[c];
  }
  const std::string table =
      weather_table(weathers, light, static_cast<std::int64_t>(conditions.size()), images);
  const Plot plot = sun_plot(weathers, light);
  return "<section id=\"light\"><h2>Light and weather</h2>\n" + table + "<div class=\"diagrams\"><figure>" +
         to_svg({&plot, 1}, 1, {.clip = "suns"}) + "</figure></div>\n" + condition_table(survey) +
         "</section>\n";
}

}  // namespace cps
