#include <catch2/catch.hpp>

#include "distortion/models/inverse/model_survey.h"
#include "distortion/models/projection.h"
#include "numbers/angles.h"

using namespace cps;

TEST_CASE("the survey inverts every pixel of a frame and counts those outside a region") {
  const ModelCamera camera{"", {320, 200, 80, 82, 161, 98}, KannalaBrandt{-0.02, 0.003, -0.001, 0.0001}};
  const ModelCertificate proof = certify_frame(camera);
  REQUIRE(proof.valid);
  const ModelSurvey whole = survey_inversion(camera, proof.region);
  CHECK(whole.pixels == 320 * 200);
  CHECK(whole.outside == 0);
  CHECK(whole.worst_residual_px < 1e-10);

  const double limit = radians(50);
  const double radius = project(camera.lens, {std::sin(limit), 0, std::cos(limit)}).point.x();
  std::int64_t beyond = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) beyond += to_plane(camera.pinhole, {x, y}).norm() > radius ? 1 : 0;
  const ModelSurvey inner = survey_inversion(camera, {.max_angle_rad = limit});
  CHECK(inner.pixels == whole.pixels);
  CHECK(inner.outside == beyond);
  CHECK(beyond > 1000);
}

TEST_CASE("the survey of a large frame takes a regular grid") {
  const ModelCamera camera{
      "", {8000, 2000, 4000, 4000, 4000, 1000}, UnifiedSpherical{.xi = 0.5, .distortion = {.p1 = 0.001}}};
  const ModelCertificate proof = certify_frame(camera);
  REQUIRE(proof.valid);
  const ModelSurvey survey = survey_inversion(camera, proof.region);
  CHECK(survey.pixels == 2000 * 500);
  CHECK(survey.outside == 0);
  CHECK(survey.worst_residual_px < 1e-8);
}
