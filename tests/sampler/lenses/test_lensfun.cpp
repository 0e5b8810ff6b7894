#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "distortion/pinhole.h"
#include "numbers/angles.h"
#include "sampler/lenses/lensfun/profiles.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// A database of one file with these lenses.
std::vector<LensfunProfile> database(const std::string& lenses) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "slr.xml") << "<lensdatabase version=\"1\">" << lenses << "</lensdatabase>";
  return read_lensfun(folder.path);
}

std::string lens(const std::string& more, const std::string& rows) {
  return "<lens><model>a</model>" + more + "<calibration>" + rows + "</calibration></lens>";
}

}  // namespace

TEST_CASE("profiles are read with their frame, and fisheyes are left out") {
  const auto profiles = database(
      lens("<cropfactor>1.5</cropfactor>", "<distortion model=\"poly3\" focal=\"24\" k1=\"-0.03\"/>") +
      lens("<cropfactor>2</cropfactor><aspect-ratio>4:3</aspect-ratio>",
           "<distortion model=\"ptlens\" focal=\"12\" a=\".01\" b=\"-.02\" c=\".03\"/>"
           "<distortion model=\"poly5\" focal=\"12\" real-focal=\"14\" k1=\".1\" k2=\".2\"/>") +
      lens("<type>fisheye</type>", "<distortion model=\"poly3\" focal=\"8\" k1=\"-0.3\"/>"));
  REQUIRE(profiles.size() == 3);
  CHECK(profiles[0].hfov_deg == Approx(degrees(2 * std::atan(0.5))));  // 24 mm wide
  CHECK(profiles[0].polynomial == std::array{1.03, 0.0, -0.03, 0.0, 0.0});
  const double width = std::hypot(36, 24) / 2 * 0.8;
  CHECK(profiles[1].hfov_deg == Approx(degrees(2 * std::atan(width / 24))));
  CHECK(profiles[1].polynomial[0] == Approx(0.98));
  CHECK(profiles[1].polynomial[3] == .01);
  CHECK(profiles[2].hfov_deg == Approx(degrees(2 * std::atan(width / 28))));
  CHECK(profiles[2].polynomial == std::array{1.0, 0.0, 0.1, 0.0, 0.2});
  CHECK_THROWS_WITH(database(lens("", "<distortion model=\"acm\" focal=\"8\"/>")),
                    Catch::Contains("slr.xml") && Catch::Contains("acm"));
  CHECK_THROWS_WITH(read_lensfun("/nonexistent"), Catch::Contains("liblensfun-data-v1"));
}

TEST_CASE("a third-order profile is k1 alone, in closed form") {
  for (double k : {-0.03, -0.002, 0.01}) {
    const LensfunProfile profile{.aspect = 1.5, .hfov_deg = 53, .polynomial = {1 - k, 0, k, 0, 0}};
    const auto found = converted(profile);
    REQUIRE(found);
    // An undistorted radius R (paraxial scale 1) is seen at R + κ R³.
    const double kappa = k / std::pow(1 - k, 3);
    // Barrel distortion moves the corners most, so base and photograph share their corners. Pincushion
    // distortion moves the middles of the short sides least, so they share those.
    const double reach = k < 0 ? std::hypot(1, 1.5) : 1;
    double radius = reach;
    for (int i = 0; i < 200; ++i) radius = reach / (1 + kappa * radius * radius);
    const double unit = k < 0 ? radius : radius * std::hypot(1, 1.5);
    CHECK(found->lens.k1 == Approx(kappa * unit * unit).epsilon(2e-3));
    CHECK(std::abs(found->lens.k2) < 1e-9);
    CHECK(std::abs(found->lens.k3) < 1e-9);
    CHECK(found->largest_residual < 1e-12);
  }
}

TEST_CASE("a profile that folds inside its frame is refused") {
  CHECK_FALSE(converted({.aspect = 1.5, .hfov_deg = 90, .polynomial = {1.3, 0, -0.3, 0, 0}}));
}
