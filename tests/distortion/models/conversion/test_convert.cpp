#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/conversion/convert.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "numbers/angles.h"

using namespace cps;

namespace {

/// calib_cam_to_cam.txt of 2011-09-26 (Geiger et al. 2013): K_00 and D_00.
const ModelCamera kitti{"00",
                        {1392, 512, 984.2439, 980.8141, 690.0, 233.1966},
                        Distortion{-0.3728755, 0.2037299, -0.07233722, 0.002219027, 0.001383707}};

const ModelCamera fisheye{"", {960, 400, 300, 302, 484, 197}, KannalaBrandt{-0.02, 0.003, -0.001, 0.0001}};

const std::map<std::string, double> no_polynomial{{"k1", 0}, {"k2", 0}, {"k3", 0}, {"p1", 0}, {"p2", 0}};

double parameter(const ModelCamera& camera, std::string_view name) {
  for (const auto& [known, value] : parameters(camera.lens))
    if (known == name) return value;
  FAIL("no parameter " << name);
  return 0;
}

struct Errors {
  double rms_px = 0, worst_px = 0, worst_angle_rad = 0;
};

/// Reprojection errors and angles over the grid that convert() describes.
Errors errors_between(const ModelCamera& camera, const ModelCamera& other) {
  const RayRegion region = certify_frame(camera).region, other_region = certify_frame(other).region;
  constexpr int side = 31;
  Errors errors;
  for (int i = 0; i < side * side; ++i) {
    const Eigen::Vector2d pixel((camera.pinhole.width - 1.0) * (i % side) / (side - 1),
                                (camera.pinhole.height - 1.0) * (i / side) / (side - 1));
    const Eigen::Vector3d ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel)).value();
    const double error = (to_pixel(other.pinhole, project(other.lens, ray).point) - pixel).norm();
    errors.rms_px += error * error / (side * side);
    errors.worst_px = std::max(errors.worst_px, error);
    if (const auto seen = unproject(other.lens, other_region, to_plane(other.pinhole, pixel)))
      errors.worst_angle_rad = std::max(errors.worst_angle_rad, std::acos(std::min(1.0, ray.dot(*seen))));
  }
  errors.rms_px = std::sqrt(errors.rms_px);
  return errors;
}

/// Every camera next to this one in one variable: a focal length, the principal point or a free parameter.
std::vector<ModelCamera> neighbours(const ModelCamera& camera, const std::map<std::string, double>& held) {
  std::vector<ModelCamera> result;
  for (const double step : {-1e-4, 1e-4}) {
    for (double Pinhole::*variable : {&Pinhole::fx, &Pinhole::fy, &Pinhole::cx, &Pinhole::cy}) {
      result.push_back(camera);
      result.back().pinhole.*variable += 100 * step;
    }
    const auto known = parameters(camera.lens);
    for (const auto& [name, value] : known) {
      std::map<std::string, double> changed(known.begin(), known.end());
      changed[std::string(name)] += step;
      if (held.contains(std::string(name))) continue;
      result.push_back(camera);
      result.back().lens = lens_from_parameters(family_name(camera.lens), changed);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("a family that contains the lens gives the same lens exactly") {
  const auto& lens = std::get<Distortion>(kitti.lens);
  const RationalLens rational{.k1 = lens.k1, .k2 = lens.k2, .k3 = lens.k3, .p1 = lens.p1, .p2 = lens.p2};
  const std::vector<std::pair<ModelCamera, LensModel>> cases{
      {kitti, lens},
      {kitti, rational},
      {kitti, UnifiedSpherical{.xi = 0, .distortion = lens}},
      {{"", kitti.pinhole, rational}, lens},
      {{"", kitti.pinhole, UnifiedSpherical{.xi = 0, .distortion = lens}}, rational},
      {fisheye, fisheye.lens}};
  for (const auto& [camera, expected] : cases) {
    const ConvertedCamera found = convert(camera, family_name(expected));
    INFO(description(camera.lens) << " to " << family_name(expected) << ": " << found.why);
    REQUIRE(found.why.empty());
    CHECK(found.camera == ModelCamera{camera.name, camera.pinhole, expected});
    CHECK(found.worst_px < 1e-9);
    CHECK(found.worst_angle_rad < 1e-11);
    CHECK(found.covered == 1);
  }
}

TEST_CASE("lenses that two families share are found in the other one") {
  // x / (z + ξ d) = (1/(1 + ξ)) x / (α d + (1 − α) z) with α = ξ/(1 + ξ): eucm with β = 1, double_sphere with
  // its own ξ at 0. For ξ ≤ 1, double_sphere with α = 0 is the same lens once more.
  const Pinhole pinhole{640, 480, 300, 310, 322, 236};
  for (const double xi : {0.37, 1.47}) {
    const double alpha = xi / (1 + xi);
    INFO("xi " << xi);
    const ModelCamera eucm{"", pinhole, Eucm{.alpha = alpha, .beta = 1}};
    ModelCamera unified{"", pinhole, UnifiedSpherical{.xi = xi}};
    unified.pinhole.fx *= 1 + xi;
    unified.pinhole.fy *= 1 + xi;
    for (const ModelCamera& camera : {eucm, unified}) {
      const ConvertedCamera to_eucm = convert(camera, "eucm"), to_sphere = convert(camera, "double_sphere"),
                            to_unified = convert(camera, "unified_spherical", no_polynomial);
      for (const ConvertedCamera& found : {to_eucm, to_sphere, to_unified}) {
        INFO(description(camera.lens) << " to " << description(found.camera.lens) << ": " << found.why);
        REQUIRE(found.why.empty());
        CHECK(found.worst_px < 1e-8);
        CHECK(found.covered == 1);
        CHECK(found.camera.pinhole.cx == pinhole.cx);
        CHECK(found.camera.pinhole.cy == pinhole.cy);
      }
      CHECK(parameter(to_eucm.camera, "alpha") == Approx(alpha).epsilon(1e-8));
      CHECK(parameter(to_eucm.camera, "beta") == Approx(1).epsilon(1e-8));
      CHECK(to_eucm.camera.pinhole.fx == Approx(pinhole.fx).epsilon(1e-9));
      CHECK(parameter(to_unified.camera, "xi") == Approx(xi).epsilon(1e-8));
      CHECK(to_unified.camera.pinhole.fy == Approx((1 + xi) * pinhole.fy).epsilon(1e-9));
    }
  }
}

TEST_CASE("near the axis, k1 of a unified camera is -xi / (2 (1 + xi)) and its focal length f / (1 + xi)") {
  const double xi = 0.9, focal = 40'000;
  const ModelCamera narrow{"", {640, 480, focal, focal, 319.5, 239.5}, UnifiedSpherical{.xi = xi}};
  const ConvertedCamera found = convert(narrow, "brown_conrady", {{"k2", 0}, {"k3", 0}});
  REQUIRE(found.why.empty());
  CHECK(found.camera.pinhole.fx == Approx(focal / (1 + xi)).epsilon(1e-6));
  CHECK(parameter(found.camera, "k1") == Approx(-xi / (2 * (1 + xi))).epsilon(1e-3));
}

TEST_CASE("a fit is a minimum and its errors are those it states") {
  struct Case {
    ModelCamera camera;
    const char* family;
    std::map<std::string, double> held;
  };
  for (const auto& [camera, family, held] :
       {Case{kitti, "kannala_brandt", {}}, Case{kitti, "eucm", {}},
        Case{kitti, "unified_spherical", no_polynomial}, Case{kitti, "kannala_brandt", {{"k4", 0}}}}) {
    const ConvertedCamera found = convert(camera, family, held);
    INFO(description(found.camera.lens) << " " << found.why);
    REQUIRE(found.why.empty());
    for (const auto& [name, value] : held) CHECK(parameter(found.camera, name) == value);
    CHECK(certify_frame(found.camera).valid);
    const Errors errors = errors_between(camera, found.camera);
    CHECK(found.rms_px == Approx(errors.rms_px));
    CHECK(found.worst_px == Approx(errors.worst_px));
    CHECK(found.worst_angle_rad == Approx(errors.worst_angle_rad).epsilon(1e-3));
    // Tangential terms move KITTI's corners by pixels, which no radially symmetric lens does.
    CHECK(found.rms_px > 0.1);
    CHECK(found.worst_px > found.rms_px);
    for (const ModelCamera& neighbour : neighbours(found.camera, held)) {
      INFO(description(neighbour.lens));
      CHECK(errors_between(camera, neighbour).rms_px > errors.rms_px);
    }
  }
}

TEST_CASE("a family fits no worse than one that it contains") {
  const auto rms_px = [](std::string_view family, std::map<std::string, double> held = {}) {
    const ConvertedCamera found = convert(kitti, family, held);
    INFO(family << " " << found.why);
    REQUIRE(found.why.empty());
    return found.rms_px;
  };
  auto bounded = no_polynomial;
  bounded["xi"] = 1.2;
  const double unified = rms_px("unified_spherical", no_polynomial);
  CHECK(rms_px("unified_spherical", bounded) > unified);
  CHECK(rms_px("eucm") < unified);
  CHECK(rms_px("double_sphere") <= unified * (1 + 1e-9));
  CHECK(rms_px("kannala_brandt") < rms_px("kannala_brandt", {{"k3", 0}, {"k4", 0}}));
}

TEST_CASE("fisheyes that see more than 180 degrees become those of other families") {
  for (const char* family : {"unified_spherical", "eucm", "double_sphere"}) {
    const ConvertedCamera found = convert(fisheye, family);
    INFO(family << " " << found.why);
    REQUIRE(found.why.empty());
    const ModelCertificate proof = certify_frame(found.camera);
    CHECK(proof.valid);
    CHECK(proof.region.max_angle_rad > radians(95));
    CHECK(found.camera.pinhole.cx == fisheye.pinhole.cx);
    CHECK(found.camera.pinhole.fy / found.camera.pinhole.fx ==
          Approx(fisheye.pinhole.fy / fisheye.pinhole.fx).epsilon(1e-12));
    CHECK(found.covered > 0.9);
    CHECK(found.covered <= 1);
  }
  for (const char* family : {"brown_conrady", "rational"})
    CHECK_THAT(convert(fisheye, family).why, Catch::Contains("must stay below 85"));
  // ξ = 0 shows the half space in front of the camera, and k1 … p2 do not widen it.
  CHECK_THAT(convert(fisheye, "unified_spherical", {{"xi", 0}}).why, Catch::Contains("no unified_spherical"));
}

TEST_CASE("a double sphere comes back from Kannala-Brandt as close as it went there") {
  // The error has a minimum on either side of xi = 0; the wrong one is off by much more.
  for (const auto& [focal, xi] : {std::pair(158.0, -0.18), std::pair(330.0, 0.6)}) {
    const ModelCamera camera{"", {512, 512, focal, focal, 254, 256}, DoubleSphere{.xi = xi, .alpha = 0.59}};
    const ConvertedCamera there = convert(camera, "kannala_brandt");
    INFO("xi " << xi << " " << there.why);
    REQUIRE(there.why.empty());
    const ConvertedCamera back = convert(there.camera, "double_sphere");
    INFO(description(back.camera.lens) << " " << back.why);
    REQUIRE(back.why.empty());
    CHECK(back.rms_px <= 1.05 * there.rms_px);
    CHECK(parameter(back.camera, "xi") == Approx(xi).epsilon(0.02));
  }
}

TEST_CASE("what cannot be converted is refused") {
  ModelCamera folds = kitti;
  folds.lens = Distortion{.k1 = -0.9};
  CHECK_FALSE(convert(folds, "eucm").why.empty());
  CHECK_THROWS_WITH(convert(kitti, "fisheye"), Catch::Contains("fisheye"));
  CHECK_THROWS_WITH(convert(kitti, "eucm", {{"k1", 0}}), Catch::Contains("k1"));
  CHECK_THROWS_WITH(convert(kitti, "eucm", {{"alpha", 2}}), Catch::Contains("alpha"));
}
