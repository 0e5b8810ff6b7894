#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"
#include "tests/recalibration/corner_search.h"

using namespace cps;

namespace {

/// −1 and 1 on alternate squares, through 0 at their edges.
double squares_wave(double t) {
  const double from_edge = t - std::round(t);
  const double level = std::clamp(32 * from_edge, -1.0, 1.0);
  return std::lround(t) % 2 == 0 ? level : -level;
}

/// The board as a noiseless camera with a Gaussian blur of half a pixel sees it.
cv::Mat exact_photograph(const Eigen::Isometry3d& pose, const Pinhole& camera, const Distortion& lens,
                         const Eigen::AlignedBox2d& seen) {
  constexpr int steps = 5;
  constexpr double sigma_px = 0.5, step_px = 0.3;
  cv::Mat gray(camera.height, camera.width, CV_32F);
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      double sum = 0, weights = 0;
      for (int j = -steps; j <= steps; ++j)
        for (int i = -steps; i <= steps; ++i) {
          const Eigen::Vector2d off(step_px * i, step_px * j);
          const auto ideal = undistort(lens, seen, to_plane(camera, Eigen::Vector2d(x, y) + off));
          if (!ideal) throw std::runtime_error("a pixel shows nothing");
          const Eigen::Vector3d ray = pose.linear() * ideal->homogeneous();
          const Eigen::Vector3d p = pose.translation() - ray * (pose.translation().z() / ray.z());
          const double weight = std::exp(-0.5 * off.squaredNorm() / (sigma_px * sigma_px));
          sum += weight * squares_wave(p.x()) * squares_wave(p.y());
          weights += weight;
        }
      gray.at<float>(y, x) = static_cast<float>(0.4 + 0.3 * sum / weights);
    }
  return gray;
}

double rms_error_px(const BoardView& view, const std::vector<BoardCorner>& truth) {
  REQUIRE(view.found.size() == truth.size());
  double sum = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum +=
        std::pow(view.found[i].x - truth[i].pixel.x(), 2) + std::pow(view.found[i].y - truth[i].pixel.y(), 2);
  return std::sqrt(0.5 * sum / static_cast<double>(truth.size()));
}

}  // namespace

TEST_CASE("corners are fitted without bias where lines curve, by a camera that is not quite right") {
  const Pinhole camera = pinhole_from_hfov(360, 240, radians(80));
  const Distortion lens{.k1 = -0.25, .k2 = 0.05, .k3 = 0, .p1 = 0.002, .p2 = -0.001};
  const Eigen::AlignedBox2d seen(Eigen::Vector2d(-1.3, -1), Eigen::Vector2d(1.3, 1));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(radians(180.0), Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.3, 0.2, 0) - 7.5 * pose.linear().col(2);

  const std::vector<BoardCorner> truth = visible_corners(pose, camera, lens, seen, 13, 22);
  REQUIRE(truth.size() > 30);
  const cv::Mat gray = exact_photograph(pose, camera, lens, seen);
  const BoardView found = find_corners(gray, truth, make_stream(1, "start"));

  Calibration rough;
  rough.parameters = camera_parameters(camera, lens);
  rough.parameters[0] *= 1.001;
  rough.parameters[2] += 0.2;
  rough.parameters[4] -= 0.002;
  const Eigen::AngleAxisd turn(pose.linear().transpose());
  const Eigen::Vector3d rotation = turn.angle() * turn.axis(), translation = pose.inverse().translation();
  rough.rotations = {(cv::Mat_<double>(3, 1) << rotation.x(), rotation.y(), rotation.z())};
  rough.translations = {(cv::Mat_<double>(3, 1) << translation.x(), translation.y(), translation.z())};

  const double by_search_px = rms_error_px(found, truth);
  const double by_fit_px = rms_error_px(fit_corners(gray, found, rough, 0), truth);
  INFO("cornerSubPix " << by_search_px << " px rms, fit " << by_fit_px << " px rms");
  CHECK(by_fit_px < 0.001);
  CHECK(by_search_px > 0.005);
}
