#include "tests/recalibration/zhang.h"

#include <Eigen/Dense>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <stdexcept>

#include "distortion/inverse/inverse.h"

namespace cps {
namespace {

using Normal = Eigen::Matrix<double, 9, 9>;

CameraParameters from_opencv(const OpenCvCamera& camera) {
  CameraParameters p;
  p << camera.matrix.at<double>(0, 0), camera.matrix.at<double>(1, 1), camera.matrix.at<double>(0, 2),
      camera.matrix.at<double>(1, 2), camera.coefficients.at<double>(0), camera.coefficients.at<double>(1),
      camera.coefficients.at<double>(2), camera.coefficients.at<double>(3), camera.coefficients.at<double>(4);
  return p;
}

/// Sums over all views: what is left of the normal equations once each view's pose is eliminated.
struct Normals {
  Normal reduced = Normal::Zero();
  Normal scatter = Normal::Zero();  ///< of the corners' contributions to the gradient
  CameraParameters gradient = CameraParameters::Zero();
  double squared_residuals = 0;
  int corners = 0;
};

void add_view(const BoardView& view, const OpenCvCamera& camera, const cv::Mat& rotation,
              const cv::Mat& translation, Normals& sums) {
  std::vector<cv::Point2d> projected;
  const std::vector<cv::Point3d> points(view.on_board.begin(), view.on_board.end());
  cv::Mat derivatives;  // 2N × (3 rotation, 3 translation, 2 focal, 2 centre, 5 lens)
  cv::projectPoints(points, rotation, translation, camera.matrix, camera.coefficients, projected,
                    derivatives);
  const auto rows = static_cast<Eigen::Index>(2 * points.size());
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
      derivatives.ptr<double>(), rows, derivatives.cols);
  Eigen::VectorXd residual(rows);
  for (std::size_t i = 0; i < points.size(); ++i)
    residual.segment<2>(static_cast<Eigen::Index>(2 * i)) << view.found[i].x - projected[i].x,
        view.found[i].y - projected[i].y;
  const auto pose = jacobian.leftCols<6>();
  const auto intrinsics = jacobian.middleCols<9>(6);
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> pose_normal(pose.transpose() * pose);
  const Eigen::Matrix<double, Eigen::Dynamic, 9> reduced =
      intrinsics - pose * pose_normal.solve(pose.transpose() * intrinsics);
  sums.reduced += reduced.transpose() * reduced;
  for (Eigen::Index i = 0; i < rows; i += 2) {
    const CameraParameters pull = reduced.middleRows<2>(i).transpose() * residual.segment<2>(i);
    sums.gradient += pull;
    sums.scatter += pull * pull.transpose();
  }
  sums.squared_residuals += residual.squaredNorm();
  sums.corners += static_cast<int>(points.size());
}

}  // namespace

OpenCvCamera to_opencv(const CameraParameters& p) {
  return {(cv::Mat_<double>(3, 3) << p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1),
          (cv::Mat_<double>(1, 5) << p[4], p[5], p[6], p[7], p[8])};
}

CameraParameters camera_parameters(const Pinhole& camera, const Distortion& lens) {
  CameraParameters p;
  p << camera.fx, camera.fy, camera.cx, camera.cy, lens.k1, lens.k2, lens.p1, lens.p2, lens.k3;
  return p;
}

Calibration calibrate(const std::vector<BoardView>& views, int width, int height,
                      const CameraParameters& start) {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> found;
  for (const BoardView& view : views) {
    on_board.push_back(view.on_board);
    found.push_back(view.found);
  }
  OpenCvCamera camera = to_opencv(start);
  std::vector<cv::Mat> rotations, translations;
  cv::calibrateCamera(on_board, found, {width, height}, camera.matrix, camera.coefficients, rotations,
                      translations, cv::CALIB_USE_INTRINSIC_GUESS,
                      {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-14});
  Normals sums;
  for (std::size_t v = 0; v < views.size(); ++v)
    add_view(views[v], camera, rotations[v], translations[v], sums);
  const int coordinates = 2 * sums.corners;
  const int degrees_of_freedom = coordinates - 9 - 6 * static_cast<int>(views.size());
  const double share_left = static_cast<double>(degrees_of_freedom) / coordinates;
  // In units in which the diagonal is 1: the coefficients' own differ by orders of magnitude.
  const CameraParameters unit = sums.reduced.diagonal().cwiseSqrt().cwiseInverse();
  const Normal reduced = unit.asDiagonal() * sums.reduced * unit.asDiagonal();
  const Normal scatter = unit.asDiagonal() * sums.scatter * unit.asDiagonal();
  const Normal information = share_left * reduced * scatter.ldlt().solve(reduced);
  const CameraParameters step = reduced.ldlt().solve(unit.asDiagonal() * sums.gradient);
  const CameraParameters per_unit = unit.cwiseInverse();
  return {.parameters = from_opencv(camera),
          .rotations = rotations,
          .translations = translations,
          .corner_noise_px = std::sqrt(sums.squared_residuals / degrees_of_freedom),
          .corners = sums.corners,
          .information = per_unit.asDiagonal() * information * per_unit.asDiagonal(),
          .distance_from_minimum = std::sqrt(std::max(0.0, step.dot(information * step)))};
}

double chi_squared(const Calibration& recovered, const CameraParameters& claimed) {
  const CameraParameters difference = recovered.parameters - claimed;
  return difference.dot(recovered.information * difference);
}

double worst_reprojection_px(const Calibration& recovered, const Pinhole& camera, const Distortion& lens,
                             const Eigen::AlignedBox2d& seen) {
  constexpr int steps = 40;
  std::vector<cv::Point3d> rays;
  std::vector<Eigen::Vector2d> pixels;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      pixels.emplace_back(i * (camera.width - 1.0) / steps, j * (camera.height - 1.0) / steps);
      const auto ideal = undistort(lens, seen, to_plane(camera, pixels.back()));
      if (!ideal) throw std::runtime_error("a pixel of the frame shows nothing");
      rays.emplace_back(ideal->x(), ideal->y(), 1);
    }
  const OpenCvCamera found = to_opencv(recovered.parameters);
  const cv::Mat nowhere = cv::Mat::zeros(3, 1, CV_64F);
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double worst = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    std::vector<cv::Point2d> shown;
    cv::Mat derivatives;
    cv::projectPoints(rays, cv::Mat(3, 1, CV_64F, turn.data()), nowhere, found.matrix, found.coefficients,
                      shown, derivatives);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    worst = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Eigen::Vector2d off = pixels[i] - Eigen::Vector2d(shown[i].x, shown[i].y);
      worst = std::max(worst, off.norm());
      for (int axis : {0, 1}) {
        const Eigen::Map<const Eigen::Vector3d> row(derivatives.ptr<double>(static_cast<int>(2 * i) + axis));
        normal += row * row.transpose();
        gradient += row * off[axis];
      }
    }
    turn += normal.ldlt().solve(gradient);
  }
  return worst;
}

}  // namespace cps
