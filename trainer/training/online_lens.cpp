#include "trainer/training/online_lens.h"

#include <cmath>
#include <stdexcept>

#include "distortion/warp/master_camera.h"

namespace cps {
namespace {

bool fits(const DrawnLens& lens, const KeptMaster& master) {
  const double magnification = lens.crop.camera.fx / master.camera.fx * lens.crop.certificate.max_eigenvalue;
  return lens.base.fx >= master.base.fx && magnification <= largest_magnification({.oversampling = 1});
}

}  // namespace

DrawnLens draw_online_lens(const KeptMaster& master, const OnlineLensOptions& options, Stream stream) {
  constexpr int attempts = 1000;
  const bool is_undistorted =
      random_uniform(make_stream(stream.key, "undistorted"), 0) < options.undistorted_share;
  const double range = std::log(options.zoom);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Stream draw = substream(stream, attempt);
    Pinhole camera = master.set;
    camera.fx *= std::exp(random_uniform(draw, 0, -range, range));
    camera.fy = camera.fx;
    const DrawnLens lens = is_undistorted
                               ? undistorted_lens(camera)
                               : draw_lens(camera, CropOrder::label_first, options.lens, substream(draw, 1));
    if (fits(lens, master)) return lens;
  }
  throw std::runtime_error(
      master.file.string() +
      ": no lens fits into this master: draw with less zoom, or keep masters of a recipe "
      "with milder lenses");
}

}  // namespace cps
