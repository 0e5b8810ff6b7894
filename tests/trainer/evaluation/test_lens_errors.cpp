#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/angles.h"
#include "numbers/quantile.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/lens_errors.h"

using namespace cps;

namespace {

LensErrors errors_of(const CalibratedCamera& truth, const std::vector<Outputs>& predicted) {
  const auto rays = ray_grid(truth);
  REQUIRE(rays);
  std::vector<LensPrediction> predictions;
  for (const Outputs& outputs : predicted) predictions.push_back({&truth, &*rays, outputs});
  return measure_errors(predictions);
}

}  // namespace

TEST_CASE("a perfect prediction has no error") {
  for (std::uint64_t lens = 0; lens < 10; ++lens) {
    const CalibratedCamera truth = draw_calibration({480, 270}, 75, lens);
    const LensErrors errors = errors_of(truth, {to_outputs(truth, TargetSpace::raw)});
    CHECK(errors.reprojection_mean_px == Approx(0).margin(1e-9));
    CHECK(errors.hfov_mean_deg == Approx(0).margin(1e-12));
    for (int i = 0; i < output_count; ++i) CHECK(errors.raw_rmse[i] == Approx(0).margin(1e-12));
    CHECK(errors.folding == 0);
    CHECK(errors.without_camera == 0);
  }
}

TEST_CASE("a wrong focal length moves every pixel in proportion to its distance from the principal point") {
  const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(70)), {}};
  const double scale = 1.07;
  const Pinhole longer{
      480, 270, truth.pinhole.fx * scale, truth.pinhole.fy * scale, truth.pinhole.cx, truth.pinhole.cy};
  double distance = 0;
  const auto rays = ray_grid(truth);
  for (const Eigen::Vector2d& pixel : rays->pixels)
    distance += (pixel - Eigen::Vector2d(truth.pinhole.cx, truth.pinhole.cy)).norm() /
                static_cast<double>(rays->pixels.size());
  const LensErrors errors = errors_of(truth, {to_outputs({"", longer, {}}, TargetSpace::raw)});
  CHECK(errors.reprojection_mean_px == Approx((scale - 1) * distance).epsilon(1e-9));
  CHECK(errors.hfov_mean_deg == Approx(70 - degrees(hfov_rad(longer))).epsilon(1e-9));

  // The grid's mean distance is the rectangle's: mean of |p| over a × b in closed form, a = 240, b = 135.
  const double a = 240, b = 135, d = std::hypot(a, b);
  const double exact =
      d / 3 + b * b / (6 * a) * std::log((a + d) / b) + a * a / (6 * b) * std::log((b + d) / a);
  CHECK(distance == Approx(exact).epsilon(2e-3));
}

TEST_CASE("a shifted principal point moves every pixel by the shift, whatever the lens") {
  const CalibratedCamera truth = draw_calibration({480, 270}, 90, 4);
  CalibratedCamera shifted = truth;
  shifted.pinhole.cx += 3;
  shifted.pinhole.cy -= 4;
  const LensErrors errors = errors_of(truth, {to_outputs(shifted, TargetSpace::raw)});
  CHECK(errors.reprojection_mean_px == Approx(5).epsilon(1e-9));
  CHECK(errors.raw_mae[6] == Approx(3.0 / 480));
  CHECK(errors.raw_mae[7] == Approx(4.0 / 270));
}

TEST_CASE("means, medians and root mean squares of known errors") {
  const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(60)), {}};
  std::vector<Outputs> predicted;
  for (double off_deg : {-1.0, 2.0, 6.0}) {
    predicted.push_back(to_outputs(truth, TargetSpace::raw));
    predicted.back()[0] += radians(off_deg);
  }
  const LensErrors errors = errors_of(truth, predicted);
  CHECK(errors.images == 3);
  CHECK(errors.hfov_mean_deg == Approx(3));
  CHECK(errors.hfov_median_deg == Approx(2));
  CHECK(errors.raw_mae[0] == Approx(radians(3)));
  CHECK(errors.raw_rmse[0] == Approx(radians(std::sqrt(41.0 / 3))));
  CHECK(quantile({4, 1, 3, 2}, .5) == Approx(2.5));
  CHECK(quantile({0, 10}, .95) == Approx(9.5));
}

TEST_CASE("angles of rays, focal and principal-point errors in closed form") {
  // Without distortion a longer focal length turns the ray of a pixel at distance d from atan(d/f) to
  // atan(d/f').
  const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(70)), {}};
  CalibratedCamera longer = truth;
  longer.pinhole.fx *= 1.1;
  longer.pinhole.fy *= 1.1;
  longer.pinhole.cx += 4.8;
  const RayGrid rays = ray_grid(truth).value();
  const ImageErrors e = image_errors({&truth, &rays, to_outputs(longer, TargetSpace::raw)});
  CHECK(e.focal == Approx(.1));
  CHECK(e.principal_point == Approx(2 * .01));
  CHECK(e.k1 == 0);
  longer.pinhole.cx = truth.pinhole.cx;
  double angle_deg = 0;
  for (const Eigen::Vector2d& pixel : rays.pixels) {
    const double d = (pixel - Eigen::Vector2d(truth.pinhole.cx, truth.pinhole.cy)).norm();
    angle_deg += degrees(std::atan(d / truth.pinhole.fx) - std::atan(d / longer.pinhole.fx)) /
                 static_cast<double>(rays.pixels.size());
  }
  CHECK(angular_error_deg(rays, longer).value() == Approx(angle_deg).epsilon(1e-9));
  for (std::uint64_t lens = 1; lens < 6; ++lens) {
    const CalibratedCamera drawn = draw_calibration({480, 270}, 75, lens);
    CHECK(angular_error_deg(ray_grid(drawn).value(), drawn).value() == Approx(0).margin(1e-6));
  }
  longer.distortion.k1 = -3;
  CHECK_FALSE(angular_error_deg(rays, longer));
}

TEST_CASE("AUC is the area under the curve of errors, and correlation is Pearson's") {
  const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(60)), {}};
  std::vector<Outputs> predicted;
  for (double off_deg : {0.0, .5, 2.0, 20.0}) {
    predicted.push_back(to_outputs(truth, TargetSpace::raw));
    predicted.back()[0] += radians(off_deg);
  }
  const LensErrors errors = errors_of(truth, predicted);
  // Share of images within t, integrated: steps at 0, .5 and 2 degrees.
  CHECK(errors.hfov_auc[0] == Approx((1 + .5 + 0 + 0) / 4));
  CHECK(errors.hfov_auc[1] == Approx((1 + .9 + .6 + 0) / 4));
  CHECK(errors.hfov_auc[2] == Approx((1 + .95 + .8 + 0) / 4));
  CHECK(errors.hfov_correlation == 0);  // the truth does not vary

  std::vector<ImageErrors> three(3);
  const std::vector<double> fov{1, 2, 3};
  three[0].raw[0] = 1;  // says 2, 2, 5
  three[2].raw[0] = 2;
  CHECK(summarise(three, fov).hfov_correlation == Approx(3 / std::sqrt(2 * 6.)));
}

TEST_CASE("R squared is 1 without error and 0 for the mean of the truths") {
  const std::vector<double> truth{1, 2, 6}, none(3), off{1, 1, 1};
  std::vector<double> of_mean;  // always saying 3
  for (double t : truth) of_mean.push_back(3 - t);
  CHECK(r_squared(truth, none) == 1);
  CHECK(r_squared(truth, of_mean) == Approx(0).margin(1e-15));
  CHECK(r_squared(truth, off) == Approx(1 - 3 / 14.));  // variance (4 + 1 + 9) / 3
  std::vector<double> twice_of_mean = of_mean;
  for (double& e : twice_of_mean) e *= 2;
  CHECK(r_squared(truth, twice_of_mean) == Approx(-3));
  CHECK(r_squared(std::vector{.7, .7, .7}, off) == 0);  // nothing to explain
}

TEST_CASE("predictions that are not a camera, or fold, are counted and measured as they are") {
  const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(60)), {}};
  Outputs none = to_outputs(truth, TargetSpace::raw), folds = none;
  none[0] = -.2;
  folds[1] = -3;  // 1 + 9 k1 r² < 0 well inside the frame
  const LensErrors errors = errors_of(truth, {none, folds, to_outputs(truth, TargetSpace::raw)});
  CHECK(errors.without_camera == 1);
  CHECK(errors.folding == 1);
  CHECK(errors.reprojection_p95_px > 10);  // the folding lens keeps its error
  CHECK(errors.hfov_mean_deg == Approx((60 + degrees(.2)) / 3));
}
