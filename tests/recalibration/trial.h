#pragma once

#include "renderer/paths/render_scene.h"
#include "sampler/lenses/lens_draw.h"
#include "tests/recalibration/chessboard.h"
#include "tests/recalibration/zhang.h"

namespace cps {

constexpr int views_per_lens = 4;

/// Lenses that share their masters.
struct LensSet {
  int width, height;
  double base_hfov_deg;
  int lenses;
};
Pinhole base_of(const LensSet& set);

/// One lens under test.
struct Trial {
  DrawnLens lens;
  Eigen::AlignedBox2d seen;               ///< where it is certified
  std::vector<cv::Mat> photographs = {};  ///< linear gray
  std::vector<BoardView> views = {};      ///< corners as cornerSubPix finds them
  int predicted_corners = 0;
};

CameraParameters label(const Trial& trial);

/// What calibration starts from: the label with errors added.
CameraParameters rough_start(const CameraParameters& label);

/// Lenses as a recipe with default options draws them.
std::vector<Trial> draw_trials(const LensSet& set, Stream stream);

/// The corners that one photograph through this lens should show.
std::vector<BoardCorner> corners_of(const Trial& trial, const Eigen::Isometry3d& world_from_camera);

/// Photographs the board through all lenses of the set, with one master per pose as in a dataset.
std::vector<Trial> photograph_board(const LensSet& set, const RenderScene& board, Stream stream);

/// Calibrates twice: from corners as cornerSubPix finds them, then from corners fitted with the first result.
Calibration calibrate(const Trial& trial);

}  // namespace cps
