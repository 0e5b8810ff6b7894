#include "files/html_page.h"
#include "files/markup.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/page/sections.h"

namespace cps {

std::string to_html(const Evaluation& evaluation) {
  return html_page("cps eval: " + evaluation.set,
                   "<h1>" + escaped(evaluation.set) + "</h1>\n<pre>" + escaped(evaluation.report()) +
                       "</pre>\n" + predicted_section(evaluation) + reliability_section(evaluation) +
                       error_section(evaluation) + camera_section(evaluation) + edge_section(evaluation) +
                       failure_section(evaluation));
}

}  // namespace cps
