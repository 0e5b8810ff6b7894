#include <catch2/catch.hpp>

#include "files/csv.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("a field with any contents reads back") {
  for (const std::string& text : {"", "plain", "a,b", "\"", "a \"quoted\" word", "two\nlines", "\n", "\r\n",
                                  "a\r", "\",\"\n\"", "straße"}) {
    const std::string csv = "before,field,after\n1," + csv_field(text) + ",2\n3,x,4\n";
    const CsvTable table = parse_csv(csv, "t.csv");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0] == std::vector<std::string>{"1", text, "2"});
    CHECK(table.rows[1] == std::vector<std::string>{"3", "x", "4"});
  }
}

TEST_CASE("LF and CRLF line ends are read, and a last line without one") {
  const std::vector<std::vector<std::string>> rows = {{"1", "2"}, {"", "4"}};
  CHECK(parse_csv("a,b\n1,2\n,4\n", "t.csv").rows == rows);
  CHECK(parse_csv("a,b\r\n1,2\r\n,4\r\n", "t.csv").rows == rows);
  CHECK(parse_csv("a,b\n1,2\n,4", "t.csv").rows == rows);
  CHECK(parse_csv("a,b\n", "t.csv").rows.empty());
}

TEST_CASE("errors name file, line and column") {
  CHECK_THROWS_WITH(parse_csv("a,b\n1,2\n3\n", "t.csv"), "t.csv: line 3: has 1 fields, its header 2");
  CHECK_THROWS_WITH(parse_csv("a,b\n1,\"2\n3,4\n", "t.csv"), "t.csv: line 2: a quote is not closed");
  const CsvTable table = parse_csv("name,x\n\"two\nlines\",1.5\nb,7x\nc,nan\nd,2.5\n", "t.csv");
  CHECK_THROWS_WITH(table.column("y"), "t.csv: y: column is missing");
  const std::size_t x = table.column("x");
  CHECK(table.at(0, x).number() == 1.5);
  CHECK_THROWS_WITH(table.at(1, x).number(), "t.csv: line 4: x: '7x' is not a number");
  CHECK_THROWS_WITH(table.at(1, x).whole_number(), "t.csv: line 4: x: '7x' is not a whole number");
  CHECK_THROWS_WITH(table.at(2, x).number(), Catch::Contains("line 5"));
  CHECK_THROWS_WITH(table.at(3, x).whole_number(), Catch::Contains("line 6"));
}

TEST_CASE("a table reads back from a file") {
  const TemporaryFolder folder;
  write_file(folder.path / "t.csv", std::string("a\n\"x\ny\"\n"));
  CHECK(read_csv(folder.path / "t.csv").rows == std::vector<std::vector<std::string>>{{"x\ny"}});
  CHECK_THROWS_WITH(read_csv(folder.path / "none.csv"), Catch::Contains("none.csv: cannot be read"));
}
