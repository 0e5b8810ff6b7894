#include <fmt/format.h>

#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"
#include "files/markup.h"

namespace cps {
namespace {

constexpr std::size_t max_scenes = 200, max_warnings = 200, max_cameras = 100, max_text = 400;

std::string scene_table(const std::vector<Description::Scene>& scenes) {
  std::vector<std::vector<std::string>> rows;
  for (const Description::Scene& scene : scenes) {
    if (rows.size() == max_scenes) break;
    const auto& city = scene.city;
    rows.push_back(
        {clipped(scene.file, 200), city ? clipped(city->style, 40) : "–",
         city ? std::to_string(city->seed) : "–",
         city ? fmt::format("{:.3g}, seed {}", city->traffic, city->traffic_seed) : "–",
         fmt::format("{:g}", scene.metres_per_unit), std::to_string(scene.import_warnings.size()),
         clipped(scene.credits, 200),
         "<code title=\"" + escaped(scene.sha256) + "\">" + clipped(scene.sha256, 12) + "</code>"});
  }
  std::string html = "<h3>Scenes</h3>\n";
  if (scenes.size() > max_scenes)
    html += fmt::format("<p>The first {} of {}.</p>\n", max_scenes,
                        grouped(static_cast<std::int64_t>(scenes.size())));
  return html + html_table({"file", "city", "seed", "traffic", "metres per unit", "import warnings",
                            "credits", "SHA-256"},
                           rows);
}

std::string warnings(const std::vector<Description::Scene>& scenes) {
  std::size_t count = 0;
  std::string items;
  for (const Description::Scene& scene : scenes)
    for (const std::string& warning : scene.import_warnings)
      if (count++ < max_warnings)
        items += "<li>" + clipped(scene.file, 200) + ": " + clipped(warning, max_text) + "\n";
  if (count == 0) return "";
  return fmt::format("<h3>Import warnings</h3>\n<p>{}{}.</p>\n<ul>\n",
                     grouped(static_cast<std::int64_t>(count)),
                     count > max_warnings ? fmt::format(", the first {} of them", max_warnings) : "") +
         items + "</ul>\n";
}

std::string rig_table(const std::vector<Description::Camera>& rig) {
  std::vector<std::vector<std::string>> rows;
  for (const Description::Camera& camera : rig) {
    if (rows.size() == max_cameras) break;
    const Eigen::Matrix4d& pose = camera.vehicle_from_camera;
    rows.push_back({clipped(camera.name, 100),
                    fmt::format("{:.3f}, {:.3f}, {:.3f}", pose(0, 3), pose(1, 3), pose(2, 3)),
                    fmt::format("{:.3f}, {:.3f}, {:.3f}", pose(0, 2), pose(1, 2), pose(2, 2))});
  }
  return "<h3>Rig</h3>\n" + html_table({"camera", "position: forward, left, up, m", "looks along"}, rows);
}

std::string recipe_table(const Description& description) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, value] : description.recipe)
    rows.push_back({clipped(key, 100), clipped(value, max_text)});
  return "<h3>Recipe</h3>\n<details><summary>All keys</summary>\n" + html_table({"key", "value"}, rows) +
         "</details>\n";
}

}  // namespace

std::string origin_section(const DatasetSurvey& survey) {
  if (!survey.description) return "";
  const Description& description = *survey.description;
  return "<section id=\"origin\"><h2>Scenes, rig, recipe</h2>\n" + scene_table(description.scenes) +
         warnings(description.scenes) + rig_table(description.rig) + recipe_table(description) +
         "</section>\n";
}

}  // namespace cps
