#include "tests/recalibration/corner_search.h"

#include <opencv2/imgproc.hpp>

#include "renderer/materials/srgb.h"

namespace cps {

cv::Mat linear_gray(const OIIO::ImageBuf& photograph) {
  const OIIO::ImageSpec& spec = photograph.spec();
  const auto* rgb = static_cast<const std::uint8_t*>(photograph.localpixels());
  const auto& decoded = srgb_decode_table();
  cv::Mat gray(spec.height, spec.width, CV_32F);
  for (float *level = gray.ptr<float>(), *end = level + gray.total(); level != end; ++level, rgb += 3)
    *level = (decoded[rgb[0]] + decoded[rgb[1]] + decoded[rgb[2]]) / 3;
  return gray;
}

BoardView find_corners(const cv::Mat& gray, const std::vector<BoardCorner>& predicted, Stream stream) {
  BoardView view;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const auto error = [&](int axis) {
      return random_uniform(stream, 2 * i + axis, -corner_start_error_px, corner_start_error_px);
    };
    view.on_board.emplace_back(predicted[i].on_board.x(), predicted[i].on_board.y(), 0);
    view.found.emplace_back(predicted[i].pixel.x() + error(0), predicted[i].pixel.y() + error(1));
  }
  constexpr int half_window_px = 6;
  cv::cornerSubPix(gray, view.found, {half_window_px, half_window_px}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-3});
  return view;
}

}  // namespace cps
