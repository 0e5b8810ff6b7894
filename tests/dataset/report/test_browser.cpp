#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dataset/labels/reader.h"
#include "dataset/report/page.h"
#include "distortion/inverse/inverse.h"
#include "tests/dataset/report/chromium.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

namespace {

/// Notes errors of scripts; to run before all others.
constexpr const char* watch_errors = R"(<script>
const errors = [];
addEventListener('error', event => errors.push(String(event.message)));
</script>)";

/// Chooses every lens from the list, then the next one by the button, and leaves what is shown in the
/// document.
constexpr const char* use_picker = R"(<pre id="seen"></pre><script>
addEventListener('load', () => {
  const list = document.getElementById('lens'), shown = [];
  const note = () => shown.push({
    group: document.querySelector('#lens-numbers tr').cells[1].textContent,
    numbers: [...document.querySelectorAll('#lens-numbers tr')].map(row => row.cells[1].firstChild.textContent),
    grid: document.querySelector('#lens-drawing .grid').getAttribute('d'),
    image: ['x', 'y', 'width', 'height'].map(a => Number(document.querySelector('#lens-drawing .image').getAttribute(a)))});
  note();
  for (let i = 0; i < list.options.length; ++i) {
    list.selectedIndex = i;
    list.dispatchEvent(new Event('change'));
    note();
  }
  document.getElementById('lens-next').click();
  note();
  document.getElementById('lens-straight').click();
  const style = getComputedStyle(document.body), page_width = document.documentElement.scrollWidth;
  document.documentElement.style.width = '390px';  // a phone's; Chromium's own windows are 500 wide at least
  const too_wide = [...document.querySelectorAll('body *')].filter(element => !element.closest('.scroll, svg') &&
    element.getBoundingClientRect().right > 390).map(element => element.outerHTML.slice(0, 200));
  document.getElementById('seen').textContent = '[[' + JSON.stringify({errors, shown,
    straight: document.querySelectorAll('#lens-drawing .straight').length,
    page_width, window_width: innerWidth, too_wide,
    background: style.backgroundColor, color: style.color}) + ']]';
});
</script>)";

nlohmann::json seen_in(const std::string& dom) {
  const std::size_t begin = dom.find("id=\"seen\">[["), end = dom.find("]]</pre>", begin);
  INFO(dom.substr(dom.size() < 4000 ? 0 : dom.size() - 4000));
  REQUIRE(begin != dom.npos);
  REQUIRE(end != dom.npos);
  return nlohmann::json::parse(dom.substr(begin + 12, end - begin - 12));
}

/// The lines of an SVG path of M and L.
std::vector<std::vector<Eigen::Vector2d>> lines_of(std::string path) {
  for (char& c : path)
    if (c == 'L') c = ' ';
  std::vector<std::vector<Eigen::Vector2d>> lines;
  std::istringstream pieces(path);
  for (std::string piece; std::getline(pieces, piece, 'M');) {
    std::istringstream numbers(piece);
    std::vector<Eigen::Vector2d> line;
    for (double x = 0, y = 0; numbers >> x >> y;) line.emplace_back(x, y);
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// Every point of the drawn grid, undistorted by the label's lens, lies on a straight line of a square grid.
void check_grid(const Label& label, const std::string& path) {
  const Eigen::AlignedBox2d base = frame_on_plane(base_of(label));
  const double step = base.sizes().x() / 16;
  const auto lines = lines_of(path);
  CHECK(lines.size() >= 15 + 7);
  double worst = 0;
  for (const std::vector<Eigen::Vector2d>& line : lines) {
    CHECK(line.size() == 97);
    std::vector<Eigen::Vector2d> ideal;
    for (const Eigen::Vector2d& pixel : line)
      if (const auto point = undistort(label.distortion, base, to_plane(label.camera, pixel)))
        ideal.push_back(*point);
    REQUIRE(ideal.size() > 90);  // rounding can move a line's ends out of the base
    const int across =
        std::abs(ideal[40].x() - ideal[50].x()) < std::abs(ideal[40].y() - ideal[50].y()) ? 0 : 1;
    for (const Eigen::Vector2d& point : ideal) {
      const double cells = point[across] / step;
      worst = std::max(worst, std::abs(cells - std::round(cells)));
    }
  }
  CHECK(worst < 0.02);  // of a cell: coordinates are rounded to a hundredth of a pixel
}

}  // namespace

TEST_CASE("in Chromium a report has no errors, draws every lens, and fits a phone, light and dark",
          "[slow]") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  write_small_dataset(temporary.path / "data", plan);
  std::string page = report_page(temporary.path / "data");
  page.insert(page.find("<meta charset"), watch_errors);
  page.insert(page.rfind("</body>"), use_picker);
  const std::filesystem::path file = temporary.path / "report.html";
  write_file(file, page);
  const std::string dom = dom_in_chromium(file, 1200, false);
  if (dom.empty()) {
    WARN("NOT TESTED: the report in a browser: there is no chromium");
    return;
  }
  CHECK_THAT(dom, !Catch::Contains("CONSOLE"));
  const nlohmann::json seen = seen_in(dom);
  CHECK(seen["errors"].empty());
  CHECK(seen["straight"] == 1);
  CHECK(seen["page_width"] <= seen["window_width"]);

  const Dataset dataset = read_dataset(temporary.path / "data");
  std::vector<const DatasetGroup*> groups;
  for (const DatasetGroup& group : dataset.groups)
    if (!(group.label.distortion == Distortion{})) groups.push_back(&group);
  const nlohmann::json& shown = seen["shown"];
  REQUIRE(shown.size() == groups.size() + 2);
  CHECK(shown.front() == shown[1]);  // the first lens is drawn at once
  CHECK(shown.back() == shown[1]);   // after the last comes the first
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const nlohmann::json& lens = shown[i + 1];
    const Label& label = groups[i]->label;
    CHECK(lens["group"] == groups[i]->folder.string());
    CHECK(lens["image"] == nlohmann::json({-0.5, -0.5, label.camera.width, label.camera.height}));
    std::vector<double> numbers;
    for (const auto& text : lens["numbers"])
      numbers.push_back(std::strtod(text.get<std::string>().c_str(), nullptr));
    const Distortion& d = label.distortion;
    for (double value :
         {label.camera.fx, d.k1, d.k2, d.k3, d.p1, d.p2, label.camera.cx, label.camera.cy, label.zoom})
      CHECK(std::ranges::count(numbers, value) >= 1);
    check_grid(label, lens["grid"].get<std::string>());
  }

  const nlohmann::json phone = seen_in(dom_in_chromium(file, 500, true));
  CHECK(phone["errors"].empty());
  CHECK(phone["window_width"] == 500);
  CHECK(phone["page_width"] <= 500);
  CHECK(phone["too_wide"] == nlohmann::json::array());
  CHECK(phone["background"] != seen["background"]);
  CHECK(phone["color"] != seen["color"]);
}
