#include "distortion/inverse/inversion_survey.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cmath>
#include <limits>

#include "distortion/inverse/inverse.h"
#include "distortion/inverse/iterative_inverses.h"

namespace cps {
namespace {

struct Inverter {
  const char* name;
  Eigen::Vector2d (*undistort)(const Distortion&, const Eigen::Vector2d&, int steps);
  int steps;
};
constexpr std::array<Inverter, 4> inverters{{{"ratio, 5 steps (OpenCV)", undistort_by_ratio, 5},
                                             {"ratio, 100 steps", undistort_by_ratio, 100},
                                             {"fixed point, 100 steps", undistort_by_fixed_point, 100},
                                             {"Newton, 10 steps", undistort_by_newton, 10}}};

void count_wrong(InverterErrors& errors, double error_px, const Eigen::Vector2d& pixel, double radius_px) {
  errors.worst_px = std::max(errors.worst_px, error_px);
  if (error_px <= InversionSurvey::tolerance_px) return;
  if (errors.wrong_pixels++ > 0 && radius_px >= errors.first_wrong_radius_px) return;
  errors.first_wrong_radius_px = radius_px;
  errors.first_wrong_px = pixel;
}

void survey_pixel(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box,
                  const Eigen::Vector2d& pixel, InversionSurvey& survey) {
  const Pinhole& camera = calibrated.pinhole;
  const Distortion& lens = calibrated.distortion;
  const Eigen::Vector2d distorted = to_plane(camera, pixel), focal(camera.fx, camera.fy);
  ++survey.pixels;
  const auto ideal = undistort(lens, box, distorted);
  if (!ideal) {
    ++survey.outside;
    return;
  }
  survey.worst_residual_px =
      std::max(survey.worst_residual_px, (distort(lens, *ideal) - distorted).cwiseProduct(focal).norm());
  const double radius_px = distorted.cwiseProduct(focal).norm();
  for (std::size_t i = 0; i < inverters.size(); ++i) {
    const Eigen::Vector2d found = inverters[i].undistort(lens, distorted, inverters[i].steps);
    const double error_px = (found - *ideal).cwiseProduct(focal).norm();
    count_wrong(survey.others[i],
                std::isfinite(error_px) ? error_px : std::numeric_limits<double>::infinity(), pixel,
                radius_px);
  }
}

InversionSurvey joined(InversionSurvey a, const InversionSurvey& b) {
  a.pixels += b.pixels;
  a.outside += b.outside;
  a.worst_residual_px = std::max(a.worst_residual_px, b.worst_residual_px);
  for (std::size_t i = 0; i < a.others.size(); ++i) {
    InverterErrors& one = a.others[i];
    const InverterErrors& other = b.others[i];
    if (other.wrong_pixels > 0 &&
        (one.wrong_pixels == 0 || other.first_wrong_radius_px < one.first_wrong_radius_px)) {
      one.first_wrong_radius_px = other.first_wrong_radius_px;
      one.first_wrong_px = other.first_wrong_px;
    }
    one.wrong_pixels += other.wrong_pixels;
    one.worst_px = std::max(one.worst_px, other.worst_px);
  }
  return a;
}

}  // namespace

InversionSurvey survey_inversion(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box) {
  const Pinhole& camera = calibrated.pinhole;
  constexpr double max_pixels = 1e6;
  const int step = std::max(1, int(std::sqrt(double(camera.width) * camera.height / max_pixels)));
  InversionSurvey nothing;
  for (const Inverter& inverter : inverters) nothing.others.push_back({.name = inverter.name});
  const int rows = (camera.height + step - 1) / step;
  return tbb::parallel_reduce(
      tbb::blocked_range<int>(0, rows), nothing,
      [&](const tbb::blocked_range<int>& range, InversionSurvey survey) {
        for (int row = range.begin(); row < range.end(); ++row)
          for (int x = 0; x < camera.width; x += step) survey_pixel(calibrated, box, {x, row * step}, survey);
        return survey;
      },
      joined);
}

}  // namespace cps
