#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/ray_comparison.h"
#include "trainer/evaluation/ray_errors.h"

using namespace cps;

namespace {

ModelCamera centred(const LensModel& lens, double focal_px, int width = 299, int height = 299) {
  return {"c", {width, height, focal_px, focal_px, .5 * (width - 1), .5 * (height - 1)}, lens};
}

/// Mean over the pixels of a function of the distance from the image's middle.
template <typename Function>
double mean_over(const RayTruth& truth, Function of_distance_px) {
  double sum = 0;
  for (const Eigen::Vector2d& pixel : truth.pixels)
    sum += of_distance_px((pixel - Eigen::Vector2d(truth.camera.pinhole.cx, truth.camera.pinhole.cy)).norm());
  return sum / static_cast<double>(truth.pixels.size());
}

/// What compare_rays() takes.
struct ComparedImages {
  std::vector<RayErrors> network, mean;
  std::vector<int> clusters;
  std::vector<std::string> cameras;

  RayComparison compare() const { return compare_rays(network, mean, clusters, cameras, 200, 1); }
};

/// Forty images of one camera, two at each place, with errors that grow from 1 to 4.9 degrees.
ComparedImages compared_images() {
  ComparedImages images;
  for (int i = 0; i < 40; ++i) {
    const double angle_deg = 1 + .1 * i;
    images.network.push_back(
        {RayAngles{angle_deg, 2 * angle_deg, .5 * angle_deg}, 10 * angle_deg, angle_deg});
    images.mean.push_back({RayAngles{8, 9, 7}, 50, 6});
    images.clusters.push_back(i / 2);
    images.cameras.push_back("front");
  }
  return images;
}

}  // namespace

TEST_CASE("the same lens has no error in ray space whatever its family") {
  const LensModel lenses[] = {Distortion{-.2, .04, 0, .001, -.002}, UnifiedSpherical{.xi = .8},
                              KannalaBrandt{-.02, .003, 0, 0}, Eucm{.6, 1.1}};
  for (const LensModel& lens : lenses) {
    INFO(family_name(lens));
    const ModelCamera camera = centred(lens, 240);
    const auto truth = ray_truth(camera);
    REQUIRE(truth);
    CHECK(truth->pixels.size() == 24 * 24);
    const RayErrors errors = ray_errors(*truth, camera);
    REQUIRE(errors.angles);
    CHECK(errors.angles->mean_deg == Approx(0).margin(1e-6));
    CHECK(errors.angles->p95_deg == Approx(0).margin(1e-6));
    CHECK(errors.angles->turned_mean_deg == Approx(0).margin(1e-6));
    CHECK(errors.reprojection_px.value() == Approx(0).margin(1e-6));
    CHECK(errors.seen_hfov_deg.value() == Approx(0).margin(1e-6));
  }
}

TEST_CASE("a focal length that is wrong by a factor turns rays by a known angle") {
  constexpr double f = 200, s = 1.2;
  const auto truth = ray_truth(centred(Distortion{}, f));
  REQUIRE(truth);
  const RayErrors errors = ray_errors(*truth, centred(Distortion{}, s * f));
  const auto angle = [&](double d) { return degrees(std::atan(d / f) - std::atan(d / (s * f))); };
  REQUIRE(errors.angles);
  CHECK(errors.angles->mean_deg == Approx(mean_over(*truth, angle)).epsilon(1e-9));
  // The error is symmetric about the axis: no turn makes it smaller.
  CHECK(errors.angles->turned_mean_deg == Approx(errors.angles->mean_deg).epsilon(1e-9));
  CHECK(errors.angles->p95_deg > errors.angles->mean_deg);
  CHECK(errors.reprojection_px.value() ==
        Approx((s - 1) * mean_over(*truth, [](double d) { return d; })).epsilon(1e-9));
  CHECK(errors.seen_hfov_deg.value() ==
        Approx(2 * degrees(std::atan(149.5 / f) - std::atan(149.5 / (s * f)))).epsilon(1e-9));
}

TEST_CASE("a stereographic lens against a pinhole in closed form") {
  // ξ = 1: a ray at the angle θ lands at tan(θ/2).
  const auto truth = ray_truth(centred(UnifiedSpherical{.xi = 1}, 160));
  REQUIRE(truth);
  const RayErrors errors = ray_errors(*truth, centred(UnifiedSpherical{.xi = 0}, 100));
  const auto angle = [](double d) { return degrees(std::abs(2 * std::atan(d / 160) - std::atan(d / 100))); };
  REQUIRE(errors.angles);
  CHECK(errors.angles->mean_deg == Approx(mean_over(*truth, angle)).epsilon(1e-9));
  CHECK(errors.seen_hfov_deg.value() ==
        Approx(2 * degrees(std::abs(2 * std::atan(149.5 / 160) - std::atan(149.5 / 100)))).epsilon(1e-7));
  // The corner's ray is beyond 90°, where the pinhole (arccos(−0)) shows nothing.
  CHECK(2 * std::atan(149.5 * std::sqrt(2.0) / 160) > radians(90));
  CHECK_FALSE(errors.reprojection_px);
  const RayErrors back = ray_errors(*ray_truth(centred(UnifiedSpherical{.xi = 0}, 100)),
                                    centred(UnifiedSpherical{.xi = 1}, 160));
  const auto shift = [](double d) { return std::abs(160 * std::tan(std::atan(d / 100) / 2) - d); };
  CHECK(back.reprojection_px.value() ==
        Approx(mean_over(*ray_truth(centred(UnifiedSpherical{.xi = 0}, 100)), shift)).epsilon(1e-9));
}

TEST_CASE("a pure rotation has the angles of a rotation and vanishes after the best turn") {
  const auto truth = ray_truth(centred(UnifiedSpherical{.xi = .5}, 150));
  REQUIRE(truth);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -.5).normalized();
  constexpr double turn_deg = 7;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(radians(turn_deg), axis).toRotationMatrix();
  std::vector<Eigen::Vector3d> turned;
  double expected_deg = 0;
  for (const Eigen::Vector3d& ray : truth->rays) {
    turned.push_back(rotation * ray);
    expected_deg += degrees(2 * std::asin(axis.cross(ray).norm() * std::sin(radians(turn_deg) / 2))) /
                    static_cast<double>(truth->rays.size());
  }
  const RayAngles angles = angles_between(truth->rays, turned);
  CHECK(angles.mean_deg == Approx(expected_deg).epsilon(1e-9));
  CHECK(angles.p95_deg <= turn_deg + 1e-9);
  CHECK(angles.turned_mean_deg == Approx(0).margin(1e-6));
  CHECK(nearest_rotation(truth->rays, turned).isApprox(rotation, 1e-9));
  // Rays of one plane leave a reflection open; the result is a rotation.
  const std::vector<Eigen::Vector3d> flat{{1, 0, 0}, {0, 1, 0}, {.6, .8, 0}},
      mirrored{{-1, 0, 0}, {0, 1, 0}, {-.6, .8, 0}};
  CHECK(nearest_rotation(flat, mirrored).determinant() == Approx(1));
  CHECK(angles_between(mirrored, flat).turned_mean_deg == Approx(0).margin(1e-6));
}

TEST_CASE("what cannot be compared is left out and counted") {
  // A fisheye that sees 200° along its row: no Brown–Conrady camera shows its outer rays.
  const auto camera = camera_from_seen_hfov(KannalaBrandt{}, 299, 299, radians(200));
  REQUIRE(camera);
  const auto fisheye = ray_truth(*camera);
  REQUIRE(fisheye);
  const RayErrors narrow = ray_errors(*fisheye, centred(Distortion{}, 200));
  CHECK(narrow.angles.has_value());
  CHECK_FALSE(narrow.reprojection_px);
  CHECK(narrow.seen_hfov_deg.has_value());

  const auto truth = ray_truth(centred(Distortion{}, 300));
  REQUIRE(truth);
  const RayErrors none = ray_errors(*truth, std::nullopt);
  CHECK_FALSE(none.angles);
  CHECK_FALSE(none.reprojection_px);
  // With ξ = 1.2 no ray lands beyond 1.51 focal lengths: the corner of this frame shows none.
  const RayErrors short_of = ray_errors(*truth, centred(UnifiedSpherical{.xi = 1.2}, 60));
  CHECK_FALSE(short_of.angles);
  CHECK(short_of.reprojection_px.has_value());
  const RaySummary summary = summarise(std::vector{narrow, none, short_of});
  CHECK(summary.images == 3);
  CHECK(summary.without_angles == 2);
  CHECK(summary.without_reprojection == 2);
  CHECK(summary.angle_mean_deg == Approx(narrow.angles->mean_deg));
  CHECK(summary.reprojection_mean_px == Approx(*short_of.reprojection_px));
}

TEST_CASE("rays of a Brown-Conrady camera are those of its reprojection grid") {
  const CalibratedCamera camera = draw_calibration({480, 270}, 75, 3);
  const auto truth = ray_truth(model_camera(camera));
  const auto grid = ray_grid(camera);
  REQUIRE((truth && grid));
  CHECK((truth->pixels == grid->pixels));
  const CalibratedCamera other = draw_calibration({480, 270}, 80, 5);
  const RayErrors errors = ray_errors(*truth, model_camera(other));
  CHECK(errors.reprojection_px.value() == Approx(reprojection_error_px(*grid, other)).epsilon(1e-9));
  CHECK(errors.angles->mean_deg == Approx(angular_error_deg(*grid, other).value()).epsilon(1e-6));
}

TEST_CASE("a comparison has an interval about each of the network's numbers") {
  const ComparedImages images = compared_images();
  const RayComparison c = images.compare();
  CHECK(c.network.angle_mean_deg == Approx(2.95));
  CHECK(c.network.angle_median_deg == Approx(2.95));
  CHECK(c.network.angle_p95_deg == Approx(5.9));
  CHECK(c.network.turned_mean_deg == Approx(1.475));
  CHECK(c.network.reprojection_mean_px == Approx(29.5));
  CHECK(c.training_mean.seen_hfov_mean_deg == Approx(6));
  REQUIRE(c.intervals.size() == ray_numbers().size());
  for (std::size_t k = 0; k < c.intervals.size(); ++k) {
    CHECK(c.intervals[k].low < c.network.*ray_numbers()[k].value);
    CHECK(c.intervals[k].high > c.network.*ray_numbers()[k].value);
  }
  CHECK(to_json(c).dump() == to_json(images.compare()).dump());
  CHECK_THAT(report(c), Catch::Contains("after the best turn") && Catch::Contains("2.95"));
}

TEST_CASE("a comparison has the numbers of each camera alone") {
  ComparedImages images = compared_images();
  const RayComparison of_one = images.compare();
  CHECK(of_one.by_camera.empty());
  CHECK_FALSE(to_json(of_one).contains("by_camera"));
  CHECK_THAT(report(of_one), !Catch::Contains("by camera"));

  // The names are in no order, and the last camera's predictions are none.
  for (int i = 0; i < 40; ++i) images.cameras[i] = i < 10 ? "right" : i < 36 ? "left" : "rear";
  for (int i = 36; i < 40; ++i) images.network[i] = {};
  const RayComparison c = images.compare();
  REQUIRE(c.by_camera.size() == 3);
  CHECK(c.by_camera[0].camera == "left");
  CHECK(c.by_camera[1].camera == "rear");
  CHECK(c.by_camera[2].camera == "right");
  double weighted_deg = 0;
  for (const RayComparison& camera : c.by_camera) {
    CHECK(camera.by_camera.empty());
    CHECK(camera.training_mean.angle_mean_deg == Approx(8));
    const int measured = camera.network.images - camera.network.without_angles;
    weighted_deg += camera.network.angle_mean_deg * measured / 36;
  }
  CHECK(weighted_deg == Approx(c.network.angle_mean_deg));
  CHECK(c.by_camera[0].network.angle_mean_deg == Approx(3.25));
  CHECK(c.by_camera[2].network.angle_mean_deg == Approx(1.45));
  // Its ten images are at five places, whose means lie .2 apart.
  const Interval right = c.by_camera[2].intervals[0];
  CHECK(right.low > 1.05);
  CHECK(right.low < 1.45);
  CHECK(right.high > 1.45);
  CHECK(right.high < 1.85);

  // Cameras change nothing in the numbers of all images.
  const ComparedImages alike{images.network, images.mean, images.clusters, std::vector<std::string>(40)};
  nlohmann::json all = nlohmann::json::parse(to_json(c).dump());
  REQUIRE(all.at("by_camera").size() == 3);
  CHECK(all.at("by_camera").at(2).at("camera") == "right");
  CHECK(all.at("by_camera").at(2).at("network").at("images") == 10);
  all.erase("by_camera");
  CHECK(all.dump() == nlohmann::json::parse(to_json(alike.compare()).dump()).dump());

  // A camera without numbers has none, and not an error of 0.
  const std::string text = report(c);
  const std::string rear = text.substr(text.find("\nrear") + 1);
  CHECK_THAT(rear.substr(0, rear.find('\n')), Catch::Contains(" - ") && Catch::Contains("8"));
}
