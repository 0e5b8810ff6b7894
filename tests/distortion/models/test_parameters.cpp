#include <catch2/catch.hpp>
#include <limits>

#include "distortion/models/lens_model.h"
#include "distortion/models/model_camera.h"

using namespace cps;

namespace {

/// The parameters' names in one line.
std::string names(const LensModel& lens) {
  std::string text;
  for (const auto& [name, value] : parameters(lens)) text += std::string(name) + " ";
  return text;
}

}  // namespace

TEST_CASE("families and their parameters have the names of the published models") {
  CHECK(family_names() == std::vector<std::string_view>{"brown_conrady", "rational", "kannala_brandt",
                                                        "unified_spherical", "eucm", "double_sphere"});
  CHECK(names(Distortion{}) == "k1 k2 k3 p1 p2 ");
  CHECK(names(RationalLens{}) == "k1 k2 k3 k4 k5 k6 p1 p2 ");
  CHECK(names(KannalaBrandt{}) == "k1 k2 k3 k4 ");
  CHECK(names(UnifiedSpherical{}) == "xi k1 k2 k3 p1 p2 ");
  CHECK(names(Eucm{}) == "alpha beta ");
  CHECK(names(DoubleSphere{}) == "xi alpha ");
}

TEST_CASE("a lens made from its own names and numbers is the same lens") {
  // All numbers differ, so that exchanging any two is noticed.
  const std::vector<LensModel> lenses{
      Distortion{.k1 = -0.1, .k2 = 0.2, .k3 = -0.3, .p1 = 0.4, .p2 = -0.5},
      RationalLens{.k1 = 0.1, .k2 = 0.2, .k3 = 0.3, .k4 = 0.4, .k5 = 0.5, .k6 = 0.6, .p1 = 0.7, .p2 = 0.8},
      KannalaBrandt{.k1 = 0.1, .k2 = 0.2, .k3 = 0.3, .k4 = 0.4},
      UnifiedSpherical{.xi = 1.5, .distortion = {0.1, 0.2, 0.3, 0.4, 0.5}},
      Eucm{.alpha = 0.6, .beta = 1.1},
      DoubleSphere{.xi = -0.2, .alpha = 0.6}};
  REQUIRE(lenses.size() == std::variant_size_v<LensModel>);
  for (const LensModel& lens : lenses) {
    CHECK(family_name(lens) == family_names()[lens.index()]);
    CHECK(fault(lens).empty());
    std::map<std::string, double> named;
    for (const auto& [name, value] : parameters(lens)) named.emplace(name, value);
    CHECK(lens_from_parameters(family_name(lens), named) == lens);
  }
  CHECK(std::get<UnifiedSpherical>(lens_from_parameters("unified_spherical", {{"p2", 0.25}})).distortion.p2 ==
        0.25);
}

TEST_CASE("parameters that are not named keep the family's defaults") {
  CHECK(lens_from_parameters("eucm", {{"alpha", 0.5}}) == LensModel(Eucm{.alpha = 0.5, .beta = 1}));
  CHECK(lens_from_parameters("kannala_brandt", {}) == LensModel(KannalaBrandt{}));
}

TEST_CASE("unknown families and parameters are refused with the known ones") {
  CHECK_THROWS_WITH(lens_from_parameters("fisheye", {}),
                    "lens: unknown family 'fisheye'; use one of brown_conrady, rational, kannala_brandt, "
                    "unified_spherical, eucm, double_sphere");
  CHECK_THROWS_WITH(lens_from_parameters("eucm", {{"xi", 1}}),
                    "eucm: unknown parameter 'xi'; use alpha, beta");
}

TEST_CASE("numbers outside a family's range are refused by name") {
  CHECK_THROWS_WITH(lens_from_parameters("eucm", {{"beta", 0}}), "eucm: beta: must be above 0, is 0");
  CHECK(fault(Eucm{.alpha = 1.01}) == "alpha: must be between 0 and 1, is 1.01");
  CHECK(fault(Eucm{.alpha = -0.01}) == "alpha: must be between 0 and 1, is -0.01");
  CHECK(fault(UnifiedSpherical{.xi = -0.1}) == "xi: must be at least 0, is -0.1");
  CHECK(fault(DoubleSphere{.xi = -1}) == "xi: must be above -1 and at most 1, is -1");
  CHECK(fault(DoubleSphere{.xi = 1.5}) == "xi: must be above -1 and at most 1, is 1.5");
  CHECK(fault(DoubleSphere{.xi = 0, .alpha = 2}) == "alpha: must be between 0 and 1, is 2");
  CHECK(fault(KannalaBrandt{.k3 = std::nan("")}) == "k3: must be finite");
  CHECK(fault(RationalLens{.k6 = std::numeric_limits<double>::infinity()}) == "k6: must be finite");
  CHECK(fault(UnifiedSpherical{.xi = 1, .distortion = {.p1 = std::nan("")}}) == "p1: must be finite");
  // The ends of the ranges are lenses.
  for (const LensModel& lens : std::vector<LensModel>{UnifiedSpherical{}, Eucm{.alpha = 1},
                                                      DoubleSphere{.xi = 1, .alpha = 0}, DoubleSphere{}})
    CHECK(fault(lens).empty());
}

TEST_CASE("a description names family and parameters") {
  CHECK(description(KannalaBrandt{.k1 = -0.02, .k2 = 0.00123456789}) ==
        "kannala_brandt, k1 -0.02, k2 0.00123457, k3 0, k4 0");
}

TEST_CASE("resizing a camera of any family moves its pinhole only") {
  const ModelCamera camera{
      "front", {640, 362, 511, 498, 331.25, 170.5}, DoubleSphere{.xi = 0.1, .alpha = 0.6}};
  const ModelCamera wide = resized(camera, 1280, 181);
  CHECK(wide == ModelCamera{"front", {1280, 181, 1022, 249, 663, 85}, camera.lens});
}
