#include "files/html_page.h"

#include <algorithm>

#include "files/markup.h"

namespace cps {
namespace {

/// The rules on svg undo colours that plot.cpp writes as attributes, which any rule of CSS overrides.
constexpr const char* common_style = R"css(
:root{color-scheme:light dark;--page:#fff;--card:#f6f7f9;--text:#1c2126;--faint:#5b6570;--line:#d5dae0;--accent:#0b66b2;
--good:#116b34;--bad:#b3261e;--blue:#0072b2;--orange:#d55e00;--green:#009e73;--pink:#cc79a7;--yellow:#e69f00;--sky:#56b4e9}
@media(prefers-color-scheme:dark){:root{--page:#14171b;--card:#1c2127;--text:#e4e8ec;--faint:#9aa5b1;--line:#353d47;
--accent:#6cb6ff;--good:#6fd08c;--bad:#ff8a80;--blue:#4aa8e8;--orange:#f08a3c;--green:#2fc698;--pink:#dd93ba;--yellow:#f0b93a;--sky:#8ccdf2}}
*{box-sizing:border-box}
body{font:15px/1.5 system-ui,sans-serif;color:var(--text);background:var(--page);max-width:1280px;margin:0 auto;padding:1em}
h1{font-size:1.7em;margin:.4em 0;overflow-wrap:anywhere}h2{font-size:1.3em;margin:2em 0 .5em}h3{font-size:1.05em;margin:1.4em 0 .4em}
a{color:var(--accent)}p{max-width:80ch}code,pre{font-size:.9em}pre{overflow-x:auto}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
th,td{text-align:left;vertical-align:top;padding:.25em .9em .25em 0;border-bottom:1px solid var(--line)}th{color:var(--faint);font-weight:600}
figure{display:inline-block;margin:.5em;vertical-align:top}img,svg{max-width:100%;height:auto}
figcaption{font-size:12px;color:var(--faint);max-width:420px;overflow-wrap:anywhere}
svg text{fill:var(--text)}svg [fill="#fff"]{fill:none}svg [stroke="#fff"]{stroke:var(--page)}
svg [stroke="#ddd"]{stroke:var(--line)}svg [stroke="#888"]{stroke:var(--faint)}
svg [stroke="#0072b2"]{stroke:var(--blue)}svg text[fill="#0072b2"]{fill:var(--blue)}
svg [stroke="#d55e00"]{stroke:var(--orange)}svg text[fill="#d55e00"]{fill:var(--orange)}
svg [stroke="#009e73"]{stroke:var(--green)}svg text[fill="#009e73"]{fill:var(--green)}
svg [stroke="#cc79a7"]{stroke:var(--pink)}svg text[fill="#cc79a7"]{fill:var(--pink)}
svg [stroke="#e69f00"]{stroke:var(--yellow)}svg text[fill="#e69f00"]{fill:var(--yellow)}
svg [stroke="#56b4e9"]{stroke:var(--sky)}svg text[fill="#56b4e9"]{fill:var(--sky)}
svg [stroke="#000000"]{stroke:var(--text)}
)css";

std::string row_of(const char* cell, const std::vector<std::string>& texts) {
  std::string row = "<tr>";
  for (const std::string& text : texts) row += std::string("<") + cell + ">" + text;
  return row + "\n";
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body, const std::string& style) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + common_style + style + "</style></head>\n<body>\n" + body +
         "</body></html>\n";
}

std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return "";
  std::string table = "<div class=\"scroll\"><table>\n";
  if (std::ranges::any_of(header, [](const std::string& text) { return !text.empty(); }))
    table += row_of("th", header);
  for (const std::vector<std::string>& row : rows) table += row_of("td", row);
  return table + "</table></div>\n";
}

}  // namespace cps
