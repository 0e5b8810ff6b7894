#include <catch2/catch.hpp>

#include "apps/options.h"

using namespace cps;
namespace po = boost::program_options;

namespace {

po::variables_map parsed(const std::vector<std::string>& arguments) {
  po::options_description options("Options");
  options.add_options()("max_zoom", po::value<std::string>(), "")("lens-camera", po::value<std::string>(),
                                                                  "")("out,o", po::value<std::string>(), "")(
      "lens_draw", po::value<std::string>(), "")("label-first", po::bool_switch(), "")(
      "input", po::value<std::vector<std::string>>(), "");
  po::positional_options_description positional;
  positional.add("input", -1);
  po::variables_map values;
  // Without REQUIRE: Catch would report what parse_options() throws instead of passing it on.
  if (!parse_options(arguments, Manual{}, options, positional, values)) FAIL("help was asked for");
  return values;
}

std::string value_of(const std::vector<std::string>& arguments, const std::string& name) {
  return parsed(arguments)[name].as<std::string>();
}

}  // namespace

TEST_CASE("option names may be written with - or _, before a space or =") {
  for (const char* name : {"--max_zoom", "--max-zoom"}) {
    CHECK(value_of({name, "2"}, "max_zoom") == "2");
    CHECK(value_of({std::string(name) + "=2"}, "max_zoom") == "2");
  }
  for (const char* name : {"--lens_camera", "--lens-camera"})
    CHECK(value_of({name, "a"}, "lens-camera") == "a");
  CHECK(parsed({"--label_first"})["label-first"].as<bool>());
}

TEST_CASE("values keep their - and _, spaces and letters") {
  CHECK(value_of({"--max-zoom", "a-b_c"}, "max_zoom") == "a-b_c");
  CHECK(value_of({"--max-zoom=--max-zoom=a_b-c"}, "max_zoom") == "--max-zoom=a_b-c");
  CHECK(value_of({"-o", "mein Ordner/ä_ö-ü"}, "out") == "mein Ordner/ä_ö-ü");
  const auto input =
      parsed({"a-b_c", "--", "--max-zoom", "--lens_camera"})["input"].as<std::vector<std::string>>();
  CHECK(input == std::vector<std::string>{"a-b_c", "--max-zoom", "--lens_camera"});
}

TEST_CASE("second names are accepted") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--output", "x"}, {"--out=x"}, {"-o", "x"}, {"--output=x"}})
    CHECK(value_of(arguments, "out") == "x");
  CHECK(value_of({"--camera", "x"}, "lens-camera") == "x");
  CHECK(value_of({"--draw", "x"}, "lens_draw") == "x");
}

TEST_CASE("unknown, shortened and repeated options are refused by the name that was written") {
  CHECK_THROWS_WITH(parsed({"--no_such-option", "1"}), Catch::Contains("--no_such-option"));
  CHECK_THROWS_WITH(parsed({"--max", "1"}), Catch::Contains("--max"));
  CHECK_THROWS_WITH(parsed({"--max-zoom", "1", "--max_zoom", "2"}), Catch::Contains("max_zoom"));
  CHECK_THROWS_WITH(parsed({"--max-zoom"}), Catch::Contains("max_zoom"));
}

TEST_CASE("a path is read as a whole") {
  std::filesystem::path path;
  po::options_description options("Options");
  options.add_options()("out,o", path_value(path), "");
  po::variables_map values;
  REQUIRE(parse_options({"--out", "mein Ordner/Straße 1.glb"}, Manual{}, options, {}, values));
  po::notify(values);
  CHECK(path == "mein Ordner/Straße 1.glb");
}
