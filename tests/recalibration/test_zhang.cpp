#include <boost/math/distributions/chi_squared.hpp>
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

#include "numbers/angles.h"
#include "tests/recalibration/trial.h"

using namespace cps;

namespace {

double p_value(double statistic, int degrees_of_freedom) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees_of_freedom), statistic));
}

/// Two labels that are wrong: the principal point off by half a pixel, the focal length by .2 %.
CameraParameters shifted(CameraParameters label) {
  label[2] += 0.5;
  return label;
}
CameraParameters lengthened(CameraParameters label) {
  label.head<2>() *= 1.002;
  return label;
}

/// Corners without a picture: as predicted, but for normal noise.
BoardView noisy_corners(const std::vector<BoardCorner>& corners, double noise_px, Stream stream) {
  BoardView view;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    view.on_board.emplace_back(corners[i].on_board.x(), corners[i].on_board.y(), 0);
    view.found.emplace_back(corners[i].pixel.x() + noise_px * random_normal(stream, 2 * i),
                            corners[i].pixel.y() + noise_px * random_normal(stream, 2 * i + 1));
  }
  return view;
}

std::string row(const Trial& trial, const Calibration& found, double reprojection_px) {
  char line[200];
  const Pinhole& camera = trial.lens.crop.camera;
  const double statistic = chi_squared(found, label(trial));
  std::snprintf(line, sizeof line,
                "%4dx%-4d  H-FOV %5.1f  shift %+5.1f %+5.1f px  corners %4d  noise %.4f px  chi2 %5.1f  "
                "p %.3f  reprojection %.3f px\n",
                camera.width, camera.height, degrees(hfov_rad(camera)), camera.cx - 0.5 * (camera.width - 1),
                camera.cy - 0.5 * (camera.height - 1), found.corners, found.corner_noise_px, statistic,
                p_value(statistic, 9), reprojection_px);
  return line;
}

}  // namespace

TEST_CASE("Zhang's method judges a true label by chi-squared, and a false one") {
  const LensSet set{1392, 512, 80, 8};
  const Stream stream = make_stream(1, "synthetic board");
  constexpr double noise_px = 0.02;
  std::uint64_t drawn = 0;
  double sum = 0;
  for (Trial& trial : draw_trials(set, make_stream(stream.key, "lens"))) {
    for (int v = 0; v < views_per_lens; ++v)
      trial.views.push_back(
          noisy_corners(corners_of(trial, chessboard_pose(base_of(set), make_stream(stream.key, "pose"), v)),
                        noise_px, substream(make_stream(stream.key, "noise"), drawn++)));
    const Calibration found = calibrate(trial.views, set.width, set.height, rough_start(label(trial)));
    CHECK(found.distance_from_minimum < 0.01);
    CHECK(found.corner_noise_px == Approx(noise_px).epsilon(0.1));
    CHECK(p_value(chi_squared(found, shifted(label(trial))), 9) < 1e-9);
    CHECK(p_value(chi_squared(found, lengthened(label(trial))), 9) < 1e-9);
    sum += chi_squared(found, label(trial));
  }
  CHECK(p_value(sum, 9 * set.lenses) > 0.001);
  CHECK(p_value(sum, 9 * set.lenses) < 0.999);
}

TEST_CASE("Zhang's method finds the labels of rendered chessboards", "[slow]") {
  // A board in sunlight alone: no noise but that of pixels and sensor.
  const RenderScene scene(
      chessboard_scene(),
      {make_constant_sky(Color::Zero()), make_sun(Vec3(0.3f, 0.4f, 1).normalized(), 0.0093, Color::Ones())});
  const LensSet judged[] = {{1392, 512, 38, 3},  {1392, 512, 60, 3},  {1392, 512, 95, 3},
                            {1392, 512, 124, 3}, {1920, 1080, 46, 4}, {1920, 1080, 115, 4}};
  const LensSet reported[] = {{1392, 512, 145, 2}, {1392, 512, 152, 2}};
  std::string table;
  double sum = 0;
  int lenses = 0;
  for (const LensSet& set : judged) {
    const Stream stream = substream(make_stream(9, "zhang"), static_cast<std::uint64_t>(set.base_hfov_deg));
    for (const Trial& trial : photograph_board(set, scene, stream)) {
      const Calibration found = calibrate(trial);
      const double off_px =
          worst_reprojection_px(found, trial.lens.crop.camera, trial.lens.distortion, trial.seen);
      const std::string line = row(trial, found, off_px);
      INFO(line);
      const double statistic = chi_squared(found, label(trial));
      CHECK(found.corners >= 0.99 * trial.predicted_corners);
      CHECK(found.distance_from_minimum < 0.01);
      CHECK(p_value(statistic, 9) > 0.001);
      CHECK(off_px < 0.05);
      CHECK(p_value(chi_squared(found, shifted(label(trial))), 9) < 1e-9);
      CHECK(p_value(chi_squared(found, lengthened(label(trial))), 9) < 1e-9);
      table += line;
      sum += statistic;
      ++lenses;
    }
  }
  INFO(table << "all together: chi2 " << sum << ", p " << p_value(sum, 9 * lenses));
  CHECK(lenses == 20);
  CHECK(p_value(sum, 9 * lenses) > 0.001);

  // Wider views are reported (-s): their rims are so slanted that corners are rarely good there.
  std::string wide;
  for (const LensSet& set : reported) {
    const Stream stream = substream(make_stream(9, "zhang"), static_cast<std::uint64_t>(set.base_hfov_deg));
    for (const Trial& trial : photograph_board(set, scene, stream)) {
      const Calibration found = calibrate(trial);
      wide += row(trial, found,
                  worst_reprojection_px(found, trial.lens.crop.camera, trial.lens.distortion, trial.seen));
    }
  }
  SUCCEED(wide);
}
