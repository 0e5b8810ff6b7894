#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// One photograph of the board: corners on it (metres, z = 0) and where they were found (pixels).
struct BoardView {
  std::vector<cv::Point3f> on_board;
  std::vector<cv::Point2f> found;
};

/// A camera and its lens as nine numbers, in the order of OpenCV's: fx fy cx cy k1 k2 p1 p2 k3.
using CameraParameters = Eigen::Matrix<double, 9, 1>;
CameraParameters camera_parameters(const Pinhole& camera, const Distortion& lens);

/// The same camera as OpenCV's functions take it.
struct OpenCvCamera {
  cv::Mat matrix, coefficients;
};
OpenCvCamera to_opencv(const CameraParameters& parameters);

/// Result of Zhang's method.
struct Calibration {
  CameraParameters parameters;
  std::vector<cv::Mat> rotations, translations;  ///< from board to camera, per view
  double corner_noise_px = 0;                    ///< standard deviation per coordinate, from the residuals
  int corners = 0;
  /// Inverse covariance of `parameters`. With J the Jacobian once all poses are eliminated (Schur complement)
  /// and r the residuals, the covariance is (JᵀJ)⁻¹ (Σ Jᵀr rᵀJ) (JᵀJ)⁻¹, summed over corners (White 1980):
  /// corners of small or slanted squares are found less well than others, and not alike in all directions.
  Eigen::Matrix<double, 9, 9> information;
  /// Distance of the solution from the minimum of the sum of squares, in standard deviations.
  double distance_from_minimum = 0;
};

/// Zhang 2000 by OpenCV's calibrateCamera, all nine parameters free, started from `start`.
Calibration calibrate(const std::vector<BoardView>& views, int width, int height,
                      const CameraParameters& start);

/// (recovered − claimed)ᵀ · information · (recovered − claimed): χ² with nine degrees of freedom when the
/// claim is true and corners are found without bias.
double chi_squared(const Calibration& recovered, const CameraParameters& claimed);

/// Largest distance between where the two cameras show the same ray, over a grid of the claimed camera's
/// frame, once the recovered camera has been turned so that they agree best: a turn is the board's pose, not
/// the lens. `seen` is the rectangle on which the claimed lens is one-to-one.
double worst_reprojection_px(const Calibration& recovered, const Pinhole& camera, const Distortion& lens,
                             const Eigen::AlignedBox2d& seen);

}  // namespace cps
