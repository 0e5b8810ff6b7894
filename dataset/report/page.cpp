#include "dataset/report/page.h"

#include "dataset/labels/group_label.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"
#include "files/markup.h"

namespace cps {
namespace {

/// What html_page() does not style.
constexpr const char* report_style = R"css(
nav{display:flex;flex-wrap:wrap;gap:.3em 1.2em;padding:.6em 0;border-bottom:1px solid var(--line)}
.tiles{display:grid;grid-template-columns:repeat(auto-fill,minmax(9em,1fr));gap:.7em}
.tiles div{background:var(--card);border-radius:.5em;padding:.6em .9em;color:var(--faint)}
.tiles b{display:block;font-size:1.5em;color:var(--text);font-variant-numeric:tabular-nums}
.view{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(44%,15em),1fr));gap:.8em;margin-bottom:1em}
.view figure{margin:0}.view img{width:100%;display:block;border-radius:.3em}
.view figcaption{margin-top:.3em}
.diagrams{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,22em),1fr));gap:1em}
.maps{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,32em),1fr));gap:1em}
.diagrams figure,.maps figure{margin:0}.diagrams svg,.maps svg{width:100%}
.diagrams [stroke-linecap],.maps [stroke-linecap]{stroke-width:4.5;stroke-opacity:.8}
.picker{display:grid;gap:1em;grid-template-columns:minmax(0,1fr)}.picker>p{margin:0;max-width:none}
.picker select{max-width:100%;font:inherit}.picker button{font:inherit;min-width:2.6em}
@media(min-width:900px){.picker{grid-template-columns:minmax(0,3fr) minmax(0,2fr)}.picker>p{grid-column:1/-1}}
#lens-drawing{width:100%;max-height:80vh;background:var(--card);border-radius:.5em}
#lens-drawing *{fill:none;vector-effect:non-scaling-stroke}
#lens-drawing .image{fill:var(--page)}#lens-drawing .edge{stroke:var(--text);stroke-width:2}
#lens-drawing .grid{stroke:var(--blue);stroke-width:1.2}#lens-drawing .straight{stroke:var(--faint);stroke-width:.8;stroke-dasharray:3 3}
#lens-drawing .rim{stroke:var(--orange);stroke-width:1.6}#lens-drawing .centre{fill:var(--orange)}
.good{color:var(--good);font-weight:600}.bad{color:var(--bad);font-weight:600}li{overflow-wrap:anywhere}
)css";

std::string navigation(bool is_described) {
  std::string links =
      "<nav><a href=\"#summary\">Summary</a> <a href=\"#sheets\">Contact sheets</a> "
      "<a href=\"#lenses\">Lenses</a> <a href=\"#labels\">Labels</a> ";
  if (is_described)
    links +=
        "<a href=\"#places\">Places</a> <a href=\"#light\">Light</a> <a href=\"#origin\">Scenes, rig, "
        "recipe</a> ";
  return links + "<a href=\"#checks\">Checks</a> <a href=\"#costs\">Times and costs</a></nav>\n";
}

}  // namespace

std::string report_page(const std::filesystem::path& root, const ReportOptions& options) {
  const DatasetSurvey survey = survey_dataset(root);
  const std::string name = survey.description ? survey.description->name : "a dataset of cps relens";
  return html_page("cps report: " + name,
                   "<h1>" + clipped(name, 200) + "</h1>\n" + navigation(survey.description.has_value()) +
                       summary_section(survey) + sheets_section(survey, options) +
                       lens_section(survey, options) + label_section(survey) + place_section(survey) +
                       light_section(survey) + origin_section(survey) + check_section(root) +
                       cost_section(root) + "<p>Page made by " + escaped(generator_name()) + ".</p>\n",
                   report_style);
}

}  // namespace cps
