#include <fmt/format.h>

#include <algorithm>

#include "dataset/report/label_distributions.h"
#include "dataset/report/lens_picker_script.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/markup.h"
#include "numbers/angles.h"

namespace cps {
namespace {

/// Numbers of groups to offer: those with a lens, evenly chosen, or all if no group has one.
std::vector<std::size_t> chosen_groups(const Dataset& dataset, std::size_t max_groups) {
  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < dataset.groups.size(); ++g)
    if (!is_undistorted(dataset.groups[g].label)) groups.push_back(g);
  if (groups.empty())
    for (std::size_t g = 0; g < dataset.groups.size(); ++g) groups.push_back(g);
  const std::size_t count = std::min(max_groups, groups.size());
  for (std::size_t i = 0; i < count; ++i) groups[i] = groups[i * groups.size() / count];
  groups.resize(count);
  return groups;
}

nlohmann::ordered_json lens_json(const DatasetGroup& group, std::int64_t images) {
  const Label& label = group.label;
  const Pinhole& camera = label.camera;
  const Distortion& lens = label.distortion;
  nlohmann::ordered_json limits;
  for (std::size_t i = 0; i < lens_keys.size(); ++i) {
    limits[lens_keys[i]] = nullptr;
    if (const auto& drawn = label.limits[i]) limits[lens_keys[i]] = {drawn->low, drawn->high};
  }
  return {{"folder", group.folder.string()},
          {"part", to_string(label.part)},
          {"images", images},
          {"camera", label.rig_camera},
          {"width", camera.width},
          {"height", camera.height},
          {"fov", degrees(hfov_rad(camera))},
          {"fov_base_deg", label.fov_base_deg},
          {"fov_true_deg", {label.fov_true_h_deg, label.fov_true_v_deg, label.fov_true_d_deg}},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"k1", lens.k1},
          {"k2", lens.k2},
          {"k3", lens.k3},
          {"p1", lens.p1},
          {"p2", lens.p2},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"limits", limits},
          {"zoom", label.zoom},
          {"min_eigenvalue", label.certificate_min_eigenvalue},
          {"max_roundtrip_px", label.certificate_max_roundtrip_px}};
}

/// JSON inside a script element, which `</script` or `<!--` in a name would end.
std::string script_json(const nlohmann::ordered_json& json) {
  std::string text;
  for (char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

/// The list's entries, gathered by set.
std::string entries(const Dataset& dataset, const std::vector<std::size_t>& groups) {
  std::string html, set;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const DatasetGroup& group = dataset.groups[groups[i]];
    const std::string own_set = group.folder.parent_path().string();
    if (own_set != set) {
      if (!set.empty()) html += "</optgroup>\n";
      set = own_set;
      html += "<optgroup label=\"" + escaped(set) + "\">\n";
    }
    html += fmt::format("<option value=\"{}\">{} (k1 {:+.3g})</option>\n", i,
                        escaped(group.folder.filename().string()), group.label.distortion.k1);
  }
  return html + "</optgroup>\n";
}

}  // namespace

std::string lens_section(const DatasetSurvey& survey, const ReportOptions& options) {
  const Dataset& dataset = survey.files.dataset;
  const auto with_lens = std::ranges::count_if(
      dataset.groups, [](const DatasetGroup& group) { return !is_undistorted(group.label); });
  const std::vector<std::size_t> groups = chosen_groups(dataset, static_cast<std::size_t>(options.lenses));
  nlohmann::ordered_json lenses = nlohmann::json::array();
  for (std::size_t g : groups) lenses.push_back(lens_json(dataset.groups[g], survey.images_of_group[g]));
  return fmt::format(R"(<section id="lenses"><h2>Lenses</h2>
<p>A straight grid through the lens of a group, as the group's images show it: the rectangle is the image, the
outer line the rim of the undistorted picture. {} of {} groups with a lens.</p>
<div class="picker"><p><label>Group <select id="lens">
{}</select></label> <button id="lens-previous" type="button" aria-label="previous lens">←</button>
<button id="lens-next" type="button" aria-label="next lens">→</button>
<label><input id="lens-straight" type="checkbox"> also without the lens</label></p>
<svg id="lens-drawing" role="img"></svg>
<div class="scroll"><table id="lens-numbers"></table></div></div>
<noscript><p>The drawing needs JavaScript.</p></noscript>
<script type="application/json" id="lens-data">{}</script>
<script>{}</script></section>
)",
                     with_lens == 0 ? 0 : groups.size(), with_lens, entries(dataset, groups),
                     script_json(lenses), lens_picker_script);
}

}  // namespace cps
