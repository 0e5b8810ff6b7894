#include <catch2/catch.hpp>

#include "files/data_uri.h"
#include "files/html_page.h"
#include "files/markup.h"

using namespace cps;

TEST_CASE("a data URI holds the bytes in base64") {
  // RFC 4648, section 10.
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, base64] : vectors)
    CHECK(data_uri("text/plain", std::string(bytes)) == "data:text/plain;base64," + std::string(base64));
}

TEST_CASE("text in a page cannot become markup") {
  CHECK(escaped("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
  const std::string page = html_page("<script> & \"x\"", "<h1>body</h1>", "p{color:red}");
  CHECK_THAT(page, Catch::Contains("<title>&lt;script&gt; &amp; &quot;x&quot;</title>") &&
                       Catch::Contains("<h1>body</h1>") && Catch::Contains("p{color:red}</style>") &&
                       Catch::Contains("prefers-color-scheme:dark") && Catch::Contains("width=device-width"));
}

TEST_CASE("a table has a cell per text, and without rows there is none") {
  CHECK(html_table({"a", "b"}, {{"1", "2"}, {"3", "4"}}) ==
        "<div class=\"scroll\"><table>\n<tr><th>a<th>b\n<tr><td>1<td>2\n<tr><td>3<td>4\n</table></div>\n");
  CHECK(html_table({"", ""}, {{"1", "2"}}) ==
        "<div class=\"scroll\"><table>\n<tr><td>1<td>2\n</table></div>\n");
  CHECK(html_table({"a"}, {}).empty());
}
