#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/inverse/inversion_survey.h"
#include "distortion/inverse/iterative_inverses.h"
#include "numbers/angles.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

TEST_CASE("the ratio iteration is OpenCV's") {
  const Stream stream = make_stream(41, "ratio");
  for (int i = 0; i < 500; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, camera);
    const Eigen::Vector2d distorted = random_point(stream, i, frame_on_plane(camera));
    const cv::Matx<double, 1, 5> coefficients(lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
    for (const int steps : {5, 40}) {
      std::vector<cv::Point2d> found;
      cv::undistortPoints(std::vector<cv::Point2d>{{distorted.x(), distorted.y()}}, found, cv::Matx33d::eye(),
                          coefficients, cv::noArray(), cv::noArray(),
                          cv::TermCriteria(cv::TermCriteria::COUNT, steps, 0));
      const Eigen::Vector2d ours = undistort_by_ratio(lens, distorted, steps);
      if (!ours.allFinite() || ours.norm() > 1e6) continue;
      REQUIRE(ours.x() == Approx(found[0].x).epsilon(1e-6).margin(1e-9));
      REQUIRE(ours.y() == Approx(found[0].y).epsilon(1e-6).margin(1e-9));
    }
  }
}

TEST_CASE("on a mild lens all iterations agree with the proved inverse") {
  const Distortion lens{.k1 = -0.05, .k2 = 0.01, .p1 = 0.001, .p2 = -0.002};
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  for (double x = -0.6; x < 0.7; x += 0.3) {
    const Eigen::Vector2d ideal(x, 0.3), distorted = distort(lens, ideal);
    CHECK((undistort_by_fixed_point(lens, distorted, 100) - ideal).norm() < 1e-12);
    CHECK((undistort_by_ratio(lens, distorted, 100) - ideal).norm() < 1e-12);
    CHECK((undistort_by_newton(lens, distorted, 10) - ideal).norm() < 1e-12);
  }
}

TEST_CASE("the survey counts wrong pixels and finds the innermost one") {
  // One-to-one on its frame, but too strong for the ratio iteration to contract.
  const CalibratedCamera camera{"", {640, 400, 260, 260, 325, 190}, {.k1 = 0.35, .k2 = 0.05}};
  const FrameCertificate proof = certify_frame(camera.distortion, camera.pinhole, one_to_one);
  REQUIRE(proof.valid());
  const InversionSurvey survey = survey_inversion(camera, proof.rectangle);
  CHECK(survey.pixels == 640 * 400);
  CHECK(survey.outside == 0);
  CHECK(survey.worst_residual_px < 1e-9);

  const InverterErrors& five_steps = survey.others.front();
  std::int64_t wrong = 0;
  double first_radius = 1e9;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 640; ++x) {
      const Eigen::Vector2d distorted = to_plane(camera.pinhole, {x, y});
      const Eigen::Vector2d ideal = *undistort(camera.distortion, proof.rectangle, distorted);
      if (260 * (undistort_by_ratio(camera.distortion, distorted, 5) - ideal).norm() <= 0.1) continue;
      ++wrong;
      first_radius = std::min(first_radius, std::hypot(x - 325, y - 190));
    }
  CHECK(wrong > 1000);
  CHECK(five_steps.wrong_pixels == wrong);
  CHECK(five_steps.first_wrong_radius_px == Approx(first_radius));
  CHECK((five_steps.first_wrong_px - Eigen::Vector2d(325, 190)).norm() == Approx(first_radius));
  CHECK(five_steps.worst_px > 0.1);
}

TEST_CASE("the survey is the same for any number of threads, and big frames are sampled") {
  const CalibratedCamera camera{"", {4000, 3000, 2500, 2500, 2000, 1500}, {.k1 = -0.2, .k2 = 0.02}};
  const FrameCertificate proof = certify_frame(camera.distortion, camera.pinhole, one_to_one);
  REQUIRE(proof.valid());
  std::vector<InversionSurvey> surveys;
  for (const int threads : {1, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    surveys.push_back(survey_inversion(camera, proof.rectangle));
  }
  CHECK(surveys[0].pixels == 4000 / 3 * 1000 + 1000);
  CHECK(surveys[0].worst_residual_px == surveys[1].worst_residual_px);
  for (std::size_t i = 0; i < surveys[0].others.size(); ++i) {
    CHECK(surveys[0].others[i].wrong_pixels == surveys[1].others[i].wrong_pixels);
    CHECK(surveys[0].others[i].worst_px == surveys[1].others[i].worst_px);
    CHECK(surveys[0].others[i].first_wrong_radius_px == surveys[1].others[i].first_wrong_radius_px);
  }
}

TEST_CASE("pixels beyond a fold are counted as outside") {
  const CalibratedCamera folding{"", pinhole_from_hfov(400, 300, radians(80)), {.k1 = -0.32}};
  const FrameCertificate proof = certify_frame(folding.distortion, folding.pinhole, one_to_one);
  REQUIRE_FALSE(proof.valid());
  const InversionSurvey survey = survey_inversion(folding, proof.rectangle);
  CHECK(survey.outside > 0);
  CHECK(survey.outside < survey.pixels / 2);
}
