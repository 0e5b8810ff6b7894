#include <fmt/format.h>

#include <map>

#include "dataset/report/label_distributions.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"
#include "files/markup.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr std::size_t max_sets = 200, max_generators = 20;

constexpr std::array parts = {Part::train, Part::val, Part::test};

std::string tile(const std::string& number, const std::string& what) {
  return "<div><b>" + number + "</b>" + what + "</div>\n";
}

std::string tiles(const DatasetSurvey& survey) {
  const Dataset& dataset = survey.files.dataset;
  std::int64_t lenses = 0;
  for (const DatasetGroup& group : dataset.groups) lenses += is_undistorted(group.label) ? 0 : 1;
  std::string html = "<div class=\"tiles\">\n" +
                     tile(grouped(static_cast<std::int64_t>(dataset.images.size())), "images") +
                     tile(grouped(static_cast<std::int64_t>(dataset.groups.size())), "groups") +
                     tile(grouped(lenses), "groups with a lens");
  if (const auto& description = survey.description)
    html += tile(grouped(description->views), "views rendered") +
            tile(grouped(static_cast<std::int64_t>(description->scenes.size())), "scenes") +
            tile(grouped(static_cast<std::int64_t>(description->conditions.size())), "conditions");
  return html + "</div>\n";
}

/// The first digits of a hash, the whole of it on demand.
std::string short_hash(const std::string& hash) {
  return "<code title=\"" + escaped(hash) + "\">" + clipped(hash, 12) + "</code>";
}

std::string split_table(const DatasetSurvey& survey) {
  const Dataset& dataset = survey.files.dataset;
  std::array<std::int64_t, 3> images = {}, lenses = {}, places = {};
  for (const DatasetImage& image : dataset.images) ++images[static_cast<std::size_t>(image.part)];
  for (const DatasetGroup& group : dataset.groups)
    if (group.label.part != Part::all) ++lenses[static_cast<std::size_t>(group.label.part)];
  if (survey.frames)
    for (const auto& [map, of_map] : survey.frames->places)
      for (const MapPlace& place : of_map) ++places[static_cast<std::size_t>(place.part)];
  std::vector<std::vector<std::string>> rows;
  for (Part part : parts) {
    const auto p = static_cast<std::size_t>(part);
    rows.push_back(
        {to_string(part), grouped(images[p]),
         percent(images[p], static_cast<std::int64_t>(dataset.images.size())), grouped(lenses[p]),
         survey.frames ? grouped(places[p]) : "–",
         survey.frames ? grouped(static_cast<std::int64_t>(survey.frames->streets[p].size())) : "–",
         survey.description ? short_hash(survey.description->pixels_sha256[p]) : "–"});
  }
  return "<h3>Splits</h3>\n" + html_table({"part", "images", "share", "groups of its own", "places",
                                           "streets", "hash of its pixels"},
                                          rows);
}

struct SetTally {
  ImageSize size;
  std::int64_t groups = 0, images = 0;
  Interval hfov_deg{1e9, -1e9};
};

std::string set_table(const DatasetSurvey& survey) {
  const Dataset& dataset = survey.files.dataset;
  std::map<std::string, SetTally> sets;
  for (std::size_t g = 0; g < dataset.groups.size(); ++g) {
    const DatasetGroup& group = dataset.groups[g];
    SetTally& set = sets[group.folder.parent_path().string()];
    set.size = {group.label.camera.width, group.label.camera.height};
    ++set.groups;
    set.images += survey.images_of_group[g];
    const double hfov_deg = degrees(hfov_rad(group.label.camera));
    set.hfov_deg = {std::min(set.hfov_deg.low, hfov_deg), std::max(set.hfov_deg.high, hfov_deg)};
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, set] : sets) {
    if (rows.size() == max_sets) break;
    rows.push_back({escaped(name), fmt::format("{}×{}", set.size.width, set.size.height),
                    fmt::format("{:.4g}° … {:.4g}°", set.hfov_deg.low, set.hfov_deg.high),
                    grouped(set.groups), grouped(set.images)});
  }
  std::string html = "<h3>Sets</h3>\n";
  if (sets.size() > max_sets) html += fmt::format("<p>The first {} of {}.</p>\n", max_sets, sets.size());
  return html + html_table({"set", "size", "H-FOV of its images", "groups", "images"}, rows);
}

std::string versions(const DatasetSurvey& survey) {
  std::map<std::string, std::int64_t> generators;
  for (const DatasetGroup& group : survey.files.dataset.groups) ++generators[group.label.generator];
  std::vector<std::vector<std::string>> rows;
  if (const auto& description = survey.description) {
    rows.push_back({"dataset.json", clipped(description->generator, 200)});
    rows.push_back({"schema", std::to_string(description->schema)});
    rows.push_back({"seed", std::to_string(description->seed)});
  }
  for (const auto& [generator, labels] : generators) {
    if (rows.size() == max_generators) break;
    rows.push_back({grouped(labels) + " labels", clipped(generator, 200)});
  }
  std::size_t warnings = 0;
  if (survey.description)
    for (const Description::Scene& scene : survey.description->scenes)
      warnings += scene.import_warnings.size();
  if (warnings > 0)
    rows.push_back({"import warnings", fmt::format("<a href=\"#origin\">{} of the scenes</a>", warnings)});
  return "<h3>Made by</h3>\n" + html_table({"", ""}, rows);
}

}  // namespace

std::string summary_section(const DatasetSurvey& survey) {
  const std::string note =
      survey.description
          ? ""
          : "<p>Made by cps relens: no dataset.json and no frames.csv, so recipe, places, light "
            "and costs are not known.</p>\n";
  return "<section id=\"summary\"><h2>Summary</h2>\n" + note + tiles(survey) + split_table(survey) +
         set_table(survey) + versions(survey) + "</section>\n";
}

}  // namespace cps
