#include <catch2/catch.hpp>
#include <cstdlib>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "tests/trainer/street.h"
#include "trainer/images/orientation/measure.h"

using namespace cps;

namespace {

/// The first block of Python after this heading of a page.
std::string python_below(const std::string& heading, const std::string& page) {
  const std::string fence = "```python\n";
  const std::size_t begin = page.find(fence, page.find(heading)) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

constexpr const char* print_them = R"(
import json
words = open("street.pgm", "rb").read().split(b"\n", 3)
w, h = map(int, words[1].split())
inputs = edges(numpy.frombuffer(words[3], "uint8").reshape(h, w), 49, 27)
print(json.dumps({name: value.ravel().tolist() for name, value in inputs.items()}))
)";

}  // namespace

TEST_CASE("the Python in docs/formats.md computes the orientation that a network gets", "[slow]") {
  const TemporaryFolder folder;
  const GrayImage picture = render_street(draw_calibration({150, 83}, 70, 3), 5);
  write_file(folder.path / "street.pgm",
             "P5\n150 83\n255\n" + std::string(picture.pixels.begin(), picture.pixels.end()));
  write_file(folder.path / "edges.py",
             python_below("## Edge orientation", read_file(CPS_SOURCE "/docs/formats.md")) + print_them);
  // apt-get install python3-numpy
  REQUIRE(std::system(
              ("cd " + folder.path.string() + " && /usr/bin/python3 edges.py > edges.json").c_str()) == 0);
  const nlohmann::json theirs = read_json(folder.path / "edges.json");

  const Orientation ours = orientation_of(view_of(picture), {49, 27});
  REQUIRE(theirs.at("edge_fit").size() == orientation_number_count);
  for (int i = 0; i < orientation_number_count; ++i) {
    INFO(orientation_number_names[i]);
    CHECK(theirs["edge_fit"][i].get<double>() == Approx(ours.numbers[i]).epsilon(1e-4).margin(1e-5));
  }
  const std::size_t half = ours.planes.size() / 2;
  REQUIRE(theirs.at("edge_tilt").size() == half);
  for (std::size_t i = 0; i < half; ++i) {  // halves may be rounded the other way
    CHECK(theirs["edge_tilt"][i].get<double>() == Approx(ours.planes[i] / 508.).margin(1.01 / 508));
    CHECK(theirs["edge_confidence"][i].get<double>() ==
          Approx(ours.planes[half + i] / 127.).margin(1.01 / 127));
  }
}
