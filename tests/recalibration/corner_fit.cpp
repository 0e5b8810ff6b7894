#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <optional>

#include "tests/recalibration/corner_search.h"

namespace cps {
namespace {

constexpr int radius_px = 10;

/// A pixel near a corner: where it looks on the board, from the corner, and what it sees.
struct Look {
  double x, y, level;
};

/// erf(t/√2σ) and its derivative by t.
std::pair<double, double> edge(double t, double sigma) {
  const double u = t / sigma;
  return {std::erf(u / std::numbers::sqrt2),
          std::sqrt(2 / std::numbers::pi) / sigma * std::exp(-0.5 * u * u)};
}

/// The saddle's centre, by Gauss–Newton. `sigma`: a first guess at the edges' widths on the board.
std::optional<Eigen::Vector2d> saddle_centre(const std::vector<Look>& looks, const Eigen::Vector2d& sigma) {
  double mean = 0, contrast = 0;
  for (const Look& look : looks) mean += look.level / static_cast<double>(looks.size());
  for (const Look& look : looks)
    contrast += (look.level - mean) * (look.x * look.y > 0 ? 1 : -1) / static_cast<double>(looks.size());
  Eigen::Matrix<double, 6, 1> fit;  // x0 y0 σx σy mean contrast
  fit << 0, 0, sigma, mean, contrast;
  for (int iteration = 0; iteration < 30; ++iteration) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (const Look& look : looks) {
      const double x = look.x - fit[0], y = look.y - fit[1];
      const auto [across_x, slope_x] = edge(x, fit[2]);
      const auto [across_y, slope_y] = edge(y, fit[3]);
      const double by_x = fit[5] * slope_x * across_y, by_y = fit[5] * slope_y * across_x;
      Eigen::Matrix<double, 6, 1> row;
      row << -by_x, -by_y, -by_x * x / fit[2], -by_y * y / fit[3], 1, across_x * across_y;
      normal += row * row.transpose();
      gradient += row * (look.level - fit[4] - fit[5] * across_x * across_y);
    }
    const Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(gradient);
    fit += step;
    const Eigen::Vector2d centre = fit.head<2>(), width = fit.segment<2>(2);
    if (!fit.allFinite() || (width.array() <= 0.1 * sigma.array()).any() ||
        (centre.array().abs() > sigma.array()).any())
      return {};
    if ((step.head<2>().array().abs() < 1e-5 * sigma.array()).all()) return centre;
  }
  return {};
}

}  // namespace

BoardView fit_corners(const cv::Mat& gray, const BoardView& found, const Calibration& rough,
                      std::size_t view_index) {
  const OpenCvCamera camera = to_opencv(rough.parameters);
  cv::Matx33d board_to_camera;
  cv::Rodrigues(rough.rotations[view_index], board_to_camera);
  for (int row = 0; row < 3; ++row) board_to_camera(row, 2) = rough.translations[view_index].at<double>(row);
  const cv::Matx33d from_plane = board_to_camera.inv();

  std::vector<cv::Point3d> centres;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < found.found.size(); ++i) {
    const int middle_x = cvRound(found.found[i].x), middle_y = cvRound(found.found[i].y);
    std::vector<cv::Point2d> pixels, rays;
    for (int y = std::max(middle_y - radius_px, 0); y <= std::min(middle_y + radius_px, gray.rows - 1); ++y)
      for (int x = std::max(middle_x - radius_px, 0); x <= std::min(middle_x + radius_px, gray.cols - 1); ++x)
        if (std::hypot(x - found.found[i].x, y - found.found[i].y) < radius_px) pixels.emplace_back(x, y);
    if (pixels.empty()) continue;
    cv::undistortPoints(pixels, rays, camera.matrix, camera.coefficients, cv::noArray(), cv::noArray(),
                        {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-5});
    std::vector<Look> looks;
    Eigen::Vector2d pixel_on_board = Eigen::Vector2d::Zero();
    for (std::size_t p = 0; p < pixels.size(); ++p) {
      const cv::Vec3d board = from_plane * cv::Vec3d(rays[p].x, rays[p].y, 1);
      looks.push_back(
          {.x = board[0] / board[2] - found.on_board[i].x,
           .y = board[1] / board[2] - found.on_board[i].y,
           .level = gray.at<float>(static_cast<int>(pixels[p].y), static_cast<int>(pixels[p].x))});
      pixel_on_board = pixel_on_board.cwiseMax(
          Eigen::Vector2d(std::abs(looks.back().x), std::abs(looks.back().y)) / radius_px);
    }
    const auto centre = saddle_centre(looks, 0.8 * pixel_on_board);
    if (!centre) continue;
    centres.push_back(cv::Point3d(found.on_board[i]) + cv::Point3d(centre->x(), centre->y(), 0));
    kept.push_back(i);
  }

  BoardView view;
  if (centres.empty()) return view;
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(centres, rough.rotations[view_index], rough.translations[view_index], camera.matrix,
                    camera.coefficients, pixels);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    view.on_board.push_back(found.on_board[kept[i]]);
    view.found.emplace_back(pixels[i]);
  }
  return view;
}

}  // namespace cps
