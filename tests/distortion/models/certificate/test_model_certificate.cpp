#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/certificate/sphere_reach.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "numbers/angles.h"
#include "tests/distortion/barrel.h"
#include "tests/distortion/models/random_models.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

constexpr std::size_t families = std::variant_size_v<LensModel>;

/// A square camera of 1000 pixels a side whose frame ends at ±half of the normalised image.
Pinhole square_camera(double half) {
  return {1000, 1000, 500 / half, 500 / half, 499.5, 499.5};
}

/// A camera with its principal point off the middle, and pixels that are not square.
Pinhole skewed_camera(Stream stream, int i) {
  const Stream s = substream(stream, i);
  const double focal = std::exp(random_uniform(s, 70, std::log(250), std::log(1500)));
  return {800,
          600,
          focal,
          focal * random_uniform(s, 71, 0.9, 1.1),
          random_uniform(s, 72, 300, 500),
          random_uniform(s, 73, 220, 380)};
}

/// Points along the frame's rim, in the normalised image.
std::vector<Eigen::Vector2d> rim(const Pinhole& camera, int per_side) {
  const Eigen::AlignedBox2d frame = frame_on_plane(camera);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= per_side; ++i) {
    const Eigen::Vector2d at = frame.min() + frame.sizes() * i / per_side;
    points.emplace_back(at.x(), frame.min().y());
    points.emplace_back(at.x(), frame.max().y());
    points.emplace_back(frame.min().x(), at.y());
    points.emplace_back(frame.max().x(), at.y());
  }
  return points;
}

}  // namespace

TEST_CASE("Brown–Conrady cameras get the certificate of their frame") {
  const Pinhole pinhole = pinhole_from_hfov(1392, 512, radians(90));
  for (const Distortion& lens : {barrel(pinhole), Distortion{.k1 = -0.9}}) {
    const FrameCertificate plain = certify_frame(lens, pinhole, one_to_one);
    const ModelCertificate model = certify_frame(ModelCamera{"", pinhole, lens});
    CHECK(model.valid == plain.valid());
    CHECK(model.why == plain.why);
    CHECK(model.min_scale == plain.certificate.min_eigenvalue);
    CHECK(model.max_scale == plain.certificate.max_eigenvalue);
    REQUIRE(model.region.box);
    CHECK(model.region.box->isApprox(plain.rectangle, 0));
    const Eigen::Vector2d corner = plain.rectangle.min().cwiseAbs().cwiseMax(plain.rectangle.max());
    CHECK(model.region.max_angle_rad == Approx(std::atan(corner.norm())).epsilon(1e-12));
    CHECK(std::tan(model.witness_angle_rad) == Approx(plain.certificate.witness_radius));
  }
}

TEST_CASE("every point of a proved frame has its ray in the region") {
  const Stream stream = make_stream(51, "proved frames");
  for (std::size_t family = 0; family < families; ++family) {
    int valid = 0;
    for (int i = 0; i < 60; ++i) {
      const ModelCamera camera{"", skewed_camera(stream, i), random_model(family, stream, i)};
      const ModelCertificate proof = certify_frame(camera);
      INFO(description(camera.lens) << "; " << proof.why);
      CHECK(proof.valid == proof.why.empty());
      CHECK(proof.why.find('\n') == std::string::npos);
      if (!proof.valid) continue;
      ++valid;
      CHECK(proof.min_scale > 0);
      CHECK(proof.min_scale <= proof.max_scale);
      CHECK(proof.region.max_angle_rad < angle_limit(camera.lens));
      for (const Eigen::Vector2d& point : rim(camera.pinhole, 12)) {
        const auto ray = unproject(camera.lens, proof.region, point);
        REQUIRE(ray);
        CHECK((project(camera.lens, *ray).point - point).norm() < 1e-9 * (1 + point.norm()));
        CHECK(contains(proof.region, camera.lens, (1 - 1e-9) * *ray + 1e-9 * Eigen::Vector3d::UnitZ()));
      }
    }
    INFO("family " << family);
    CHECK(valid > 10);
  }
}

TEST_CASE("a part of a proved frame is proved, on a smaller region") {
  const Stream stream = make_stream(52, "crops");
  for (std::size_t family = 0; family < families; ++family)
    for (int i = 0; i < 25; ++i) {
      const ModelCamera camera{"", skewed_camera(stream, i), random_model(family, stream, i)};
      const ModelCertificate whole = certify_frame(camera);
      if (!whole.valid) continue;
      ModelCamera part = camera;
      part.pinhole.width = 640;
      part.pinhole.height = 480;
      part.pinhole.cx = 0.8 * (camera.pinhole.cx + 0.5) - 0.5;
      part.pinhole.cy = 0.8 * (camera.pinhole.cy + 0.5) - 0.5;
      const ModelCertificate proof = certify_frame(part);
      INFO(description(camera.lens) << "; " << proof.why);
      CHECK(proof.valid);
      CHECK(proof.region.max_angle_rad < whole.region.max_angle_rad * (1 + 1e-9));
      CHECK(proof.min_scale > whole.min_scale - 1e-4);
    }
}

TEST_CASE("a unified lens with ξ = 0 is Brown–Conrady") {
  const Pinhole pinhole = pinhole_from_hfov(1392, 512, radians(90));
  const Distortion lens = barrel(pinhole);
  const ModelCertificate plain = certify_frame(ModelCamera{"", pinhole, lens});
  const ModelCertificate unified = certify_frame(ModelCamera{"", pinhole, UnifiedSpherical{0, lens}});
  REQUIRE(unified.valid == plain.valid);
  CHECK(unified.min_scale == plain.min_scale);
  CHECK(unified.region.box->isApprox(*plain.region.box, 0));
  CHECK(unified.region.max_angle_rad == Approx(plain.region.max_angle_rad).epsilon(1e-12));
  CHECK(unified.witness_angle_rad == Approx(plain.witness_angle_rad));
}

TEST_CASE("for ξ > 1 a frame must end where rays land") {
  const double reach = 1 / std::sqrt(0.44);  // for ξ = 1.2
  const auto on = [](double corner) {
    return certify_frame(ModelCamera{"", square_camera(corner / std::sqrt(2)), UnifiedSpherical{1.2, {}}});
  };
  const ModelCertificate inside = on(0.99 * reach), outside = on(1.01 * reach);
  CHECK(inside.valid);
  CHECK(inside.region.max_angle_rad < std::acos(-1 / 1.2));
  CHECK(inside.region.max_angle_rad == Approx(angle_on_sphere(1.2, 0.99 * reach)).margin(1e-7));
  CHECK_FALSE(outside.valid);
  CHECK(outside.region.max_angle_rad == Approx(std::acos(-1 / 1.2)).margin(1e-6));
  CHECK_THAT(outside.why, Catch::Contains("1.523") && Catch::Contains("1.508") && Catch::Contains("1.2") &&
                              Catch::Contains("146.44°"));
  // For ξ ≤ 1 rays land on the whole plane.
  for (const double xi : {0.5, 1.0})
    CHECK(certify_frame(ModelCamera{"", square_camera(30), UnifiedSpherical{xi, {}}}).valid);
}

TEST_CASE("a rectangle may reach beyond the sphere's image if the frame does not need that part") {
  // A pincushion: the frame's corners lie at radius 1.45, but the rectangle that contains it ends at 1.564.
  const UnifiedSpherical lens{1.2, {.k1 = 0.1}};
  const double half = 1.45 * (1 + 0.1 * 1.45 * 1.45) / std::sqrt(2);
  const ModelCamera camera{"", square_camera(half), lens};
  const ModelCertificate proof = certify_frame(camera);
  INFO(proof.why);
  REQUIRE(proof.valid);
  CHECK(proof.region.box->max().norm() > 1 / std::sqrt(0.44));
  CHECK(proof.region.max_angle_rad == Approx(std::acos(-1 / 1.2)).margin(1e-6));
  for (const Eigen::Vector2d& point : rim(camera.pinhole, 20))
    CHECK(unproject(lens, proof.region, point).has_value());
  // For ξ = 1.3 rays land within 1.204 only.
  const ModelCertificate refused =
      certify_frame(ModelCamera{"", camera.pinhole, UnifiedSpherical{1.3, lens.distortion}});
  CHECK_FALSE(refused.valid);
  CHECK_THAT(refused.why, Catch::Contains("1.45") && Catch::Contains("1.204"));
}

TEST_CASE("unified frames against the rays of their rim") {
  const Stream stream = make_stream(53, "unified frames");
  int valid = 0, clear = 0, missed = 0, false_valid = 0;
  for (int i = 0; i < 500; ++i) {
    const Pinhole pinhole = skewed_camera(stream, i);
    const UnifiedSpherical lens{random_uniform(substream(stream, i), 80, 0, 3),
                                std::get<UnifiedSpherical>(random_model(3, stream, i)).distortion};
    const FrameCertificate plane = certify_frame(lens.distortion, pinhole, one_to_one);
    const ModelCertificate proof = certify_frame(ModelCamera{"", pinhole, lens});
    if (!plane.valid()) {
      false_valid += proof.valid;
      continue;
    }
    const double reach =
        lens.xi > 1 ? 1 / std::sqrt(lens.xi * lens.xi - 1) : std::numeric_limits<double>::infinity();
    double farthest = 0;
    for (const Eigen::Vector2d& point : rim(pinhole, 40))
      farthest = std::max(farthest, undistort(lens.distortion, plane.rectangle, point)->norm());
    valid += proof.valid;
    clear += farthest < 0.99 * reach;
    missed += farthest < 0.99 * reach && !proof.valid;
    false_valid += farthest > reach && proof.valid;
  }
  INFO(valid << " valid, " << clear << " clearly, " << missed << " missed");
  CHECK(clear > 100);
  CHECK(valid < 450);
  CHECK(false_valid == 0);
  CHECK(missed == 0);
}

TEST_CASE("a fisheye whose picture is a circle inside the frame is proved within the circle") {
  // The radius θ − 0.1 θ³ ends at θ = √(1 / 0.3) = 104.6°, radius 1.2172.
  const ModelCamera camera{"", {1000, 1000, 300, 300, 499.5, 499.5}, KannalaBrandt{.k1 = -0.1}};
  const ModelCertificate proof = certify_frame(camera);
  CHECK_FALSE(proof.valid);
  CHECK_FALSE(proof.region.box);
  CHECK(proof.region.max_angle_rad == Approx(std::sqrt(1 / 0.3)).margin(1e-5));
  CHECK(proof.min_scale > 0);
  CHECK_THAT(proof.why,
             Catch::Contains("707.1 px") && Catch::Contains("104.61°") && Catch::Contains("365.1 px"));
  const Eigen::Vector3d inside(std::sin(1.8), 0, std::cos(1.8)), outside(std::sin(1.9), 0, std::cos(1.9));
  CHECK(contains(proof.region, camera.lens, 7 * inside));
  CHECK_FALSE(contains(proof.region, camera.lens, outside));
}

TEST_CASE("the largest regions of known lenses") {
  CHECK(certify_region(KannalaBrandt{.k1 = -1 / 3.0}).region.max_angle_rad == Approx(1).margin(1e-6));
  CHECK(certify_region(Eucm{0.6, 1}).region.max_angle_rad == Approx(std::acos(-0.4 / 0.6)).margin(1e-5));
  const ModelCertificate plain = certify_region(Distortion{}, 100);
  CHECK(plain.valid);
  CHECK(plain.region.box->max().isApprox(Eigen::Vector2d(100, 100)));
  // 1 − r² at the corner of the square.
  const ModelCertificate barrel = certify_region(Distortion{.k1 = -1 / 3.0});
  CHECK(barrel.valid);
  CHECK(barrel.region.box->max().norm() == Approx(1).margin(1e-5));
  const ModelCertificate division = certify_region(RationalLens{.k4 = 1});
  CHECK(division.valid);
  CHECK(division.region.box->max().norm() == Approx(1).margin(1e-5));
  const ModelCertificate sphere = certify_region(UnifiedSpherical{1.2, {}});
  CHECK(sphere.valid);
  CHECK(sphere.region.max_angle_rad == Approx(std::acos(-1 / 1.2)).margin(1e-6));
  CHECK(certify_region(UnifiedSpherical{1, {}}, 1).region.box->max().x() == 1);
  CHECK(certify_region(UnifiedSpherical{1, {}}, 1).region.max_angle_rad ==
        Approx(2 * std::atan(std::sqrt(2))).epsilon(1e-12));
}

TEST_CASE("largest squares are one-to-one on a grid, and a little more is not") {
  const Stream stream = make_stream(54, "squares");
  int limited = 0;
  for (int i = 0; i < 400; ++i)
    for (const std::size_t family : {0, 1}) {
      const LensModel lens = random_model(family, stream, i);
      const ModelCertificate proof = certify_region(lens, 3);
      REQUIRE(proof.valid);
      const double half = proof.region.box->max().x();
      const auto smallest = [&](double scale) {
        double least = std::numeric_limits<double>::infinity();
        for (int x = -12; x <= 12; ++x)
          for (int y = -12; y <= 12; ++y) {
            const Eigen::Vector2d at = scale * half / 12 * Eigen::Vector2d(x, y);
            const DistortedPoint J = family == 0 ? evaluate(std::get<Distortion>(lens), at.x(), at.y())
                                                 : evaluate(std::get<RationalLens>(lens), at.x(), at.y());
            least = std::min(least, 0.5 * (J.xx + J.yy) - std::hypot(0.5 * (J.xx - J.yy), J.xy));
          }
        return least;
      };
      CHECK(smallest(1) > 0);
      // The limit is mostly at a corner, which the grid contains.
      limited += half < 3 && smallest(1.01) < 0;
    }
  CHECK(limited > 200);
}

TEST_CASE("contains() is the cone and the rectangle") {
  const RayRegion region{1.2, Eigen::AlignedBox2d(Eigen::Vector2d(-1, -0.5), Eigen::Vector2d(1, 0.5))};
  const LensModel plane = Distortion{}, sphere = UnifiedSpherical{0.5, {}};
  CHECK(contains(region, plane, {0.9, 0.4, 1}));
  CHECK(contains(region, plane, {1.8, 0.8, 2}));
  CHECK_FALSE(contains(region, plane, {0.9, 0.6, 1}));
  CHECK_FALSE(contains(region, plane, {0.9, 0.4, -1}));
  CHECK_FALSE(contains({0.7, region.box}, plane, {0.9, 0.4, 1}));
  CHECK(contains(region, sphere, {0.9, 0.6, 1}));  // at (0.52, 0.35)
  CHECK_FALSE(contains(region, sphere, {0, 1.6, 1}));
  CHECK(contains({3.0}, KannalaBrandt{}, {0, 1, -1}));
  CHECK_FALSE(contains({2.0}, KannalaBrandt{}, {0, 1, -1}));
  CHECK_FALSE(contains({3.0}, KannalaBrandt{}, {std::nan(""), 1, 1}));
}

TEST_CASE("unusable cameras and parameters are refused in one line") {
  const Pinhole good = pinhole_from_hfov(640, 480, radians(60));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto why = [](const Pinhole& pinhole, const LensModel& lens) {
    const ModelCertificate proof = certify_frame(ModelCamera{"", pinhole, lens});
    CHECK_FALSE(proof.valid);
    CHECK(proof.why.find('\n') == std::string::npos);
    return proof.why;
  };
  const std::vector<LensModel> lenses{Distortion{},       RationalLens{},
                                      KannalaBrandt{},    UnifiedSpherical{.xi = 0.5},
                                      Eucm{.alpha = 0.5}, DoubleSphere{.xi = 0.1, .alpha = 0.5}};
  for (const LensModel& lens : lenses) {
    INFO(description(lens));
    const ModelCertificate proof = certify_frame(ModelCamera{"", good, lens});
    INFO(proof.why);
    CHECK(proof.valid);
    Pinhole bad = good;
    bad.width = 0;
    CHECK_THAT(why(bad, lens), Catch::Contains("width"));
    for (const double focal : {0.0, nan, infinity}) {
      bad = good;
      bad.fy = focal;
      CHECK_THAT(why(bad, lens), Catch::Contains("fy"));
    }
    for (const double centre : {-5.0, 700.0, nan, infinity}) {
      bad = good;
      bad.cx = centre;
      CHECK_THAT(why(bad, lens), Catch::Contains("cx"));
    }
  }
  CHECK_THAT(why(good, KannalaBrandt{.k3 = nan}), Catch::Contains("k3"));
  CHECK_THAT(why(good, RationalLens{.k6 = infinity}), Catch::Contains("k6"));
  CHECK_THAT(why(good, UnifiedSpherical{.xi = -0.1}), Catch::Contains("xi"));
  CHECK_THAT(why(good, Eucm{.alpha = 1.5}), Catch::Contains("alpha"));
  CHECK_THAT(why(good, DoubleSphere{.xi = -1}), Catch::Contains("xi"));
  CHECK(certify_frame(ModelCamera{"", good, Eucm{.alpha = 1.5}}).region.max_angle_rad == 0);
  CHECK_FALSE(certify_region(Eucm{.alpha = nan}).valid);
  CHECK_THAT(certify_region(Distortion{}, nan).why, Catch::Contains("max_radius"));
}
