#include "trainer/fit/convergence.h"

#include "random/shuffle.h"

namespace cps {

std::vector<ConvergencePoint> convergence(std::span<const CameraFrame> frames, const OneCamera& of_all,
                                          const OneCameraOptions& options) {
  std::vector<CameraFrame> shuffled;
  for (std::size_t i : shuffled_order(frames.size(), make_stream(0, "frames of a camera")))
    shuffled.push_back(frames[i]);
  std::vector<ConvergencePoint> points;
  for (std::size_t count = 1; count < frames.size(); count *= 2)
    points.push_back(
        {static_cast<int>(count), fit_one_camera(std::span(shuffled).first(count), options).posterior});
  points.push_back({static_cast<int>(frames.size()), of_all.posterior});
  return points;
}

}  // namespace cps
