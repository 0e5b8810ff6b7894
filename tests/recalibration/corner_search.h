#pragma once

#include <OpenImageIO/imagebuf.h>

#include "random/counter_hash.h"
#include "tests/recalibration/chessboard.h"
#include "tests/recalibration/zhang.h"

namespace cps {

/// How far off each search starts (pixels), so that what is found is in the image, not in the prediction.
constexpr double corner_start_error_px = 2;

/// An 8-bit sRGB photograph as linear light, the mean of its three channels, one float a pixel.
cv::Mat linear_gray(const OIIO::ImageBuf& photograph);

/// Where OpenCV's cornerSubPix finds corners, from up to corner_start_error_px off the predicted pixels in
/// each coordinate. Good to some hundredths of a pixel: cornerSubPix is drawn towards the pixels' grid where
/// edges are sharp, and to one side where lines are curved. Enough to start from.
BoardView find_corners(const cv::Mat& gray, const std::vector<BoardCorner>& predicted, Stream stream);

/// The same corners to thousandths of a pixel, but for noise. By least squares,
/// level = mean + contrast·erf((x − x0)/√2σx)·erf((y − y0)/√2σy) is fitted to the pixels about each, where
/// (x, y) is the place on the board that `rough`, pose of view number `view_index` included, sees in a
/// pixel. So lines are straight however the lens bends them (after Datta, Kim, Kanade 2009, who rectify the
/// image instead). No label enters. Corners on which the fit does not settle are left out.
BoardView fit_corners(const cv::Mat& gray, const BoardView& found, const Calibration& rough,
                      std::size_t view_index);

}  // namespace cps
