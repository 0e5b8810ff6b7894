#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenes/city/city.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("the Khronos validator finds no error in the files of any style", "[slow]") {
  namespace fs = std::filesystem;
  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path;
  const std::string in_folder = "cd " + folder.string() + " && ";
  if (std::system((in_folder + "npm install --silent gltf-validator > npm.log 2>&1").c_str()) != 0)
    FAIL("npm could not install gltf-validator: install npm and allow it to reach its registry");
  std::ofstream(folder / "validate.js") << R"(
    const validator = require('gltf-validator'), fs = require('fs');
    validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2]))).then(report => {
      for (const m of report.issues.messages) if (m.severity === 0) console.error(m.code, m.message, m.pointer);
      process.exit(report.issues.numErrors === 0 ? 0 : 1);
    });)";
  // CPS_VALIDATOR_SEEDS=20 checks more cities.
  const char* asked = std::getenv("CPS_VALIDATOR_SEEDS");
  const std::uint64_t seeds = asked ? std::strtoull(asked, nullptr, 10) : 2;
  for (const std::string& style : city_style_names())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      INFO(style << " " << seed);
      write_city({.seed = seed, .style = city_style_from(style), .extent_m = 300}, folder / "city.glb");
      CHECK(std::system((in_folder + "node validate.js city.glb").c_str()) == 0);
    }
}
