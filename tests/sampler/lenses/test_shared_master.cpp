#include <catch2/catch.hpp>

#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"
#include "sampler/lenses/shared_master.h"

using namespace cps;

namespace {

/// A smooth picture: the value at the ideal point (x, y).
double shown(const Eigen::Vector2d& ideal) {
  return 1 + 0.3 * ideal.x() - 0.2 * ideal.y() + 0.05 * ideal.x() * ideal.y();
}

OIIO::ImageBuf picture(const Pinhole& camera) {
  OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, 1, OIIO::TypeDesc::FLOAT));
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const auto value = static_cast<float>(shown(to_plane(camera, Eigen::Vector2d(x, y))));
      image.setpixel(x, y, &value);
    }
  return image;
}

}  // namespace

TEST_CASE("every lens of a label-first view finds its pixels in the one master, whatever its base") {
  const LensOptions options{.scheme = LensScheme::shape_prior,
                            .sequential_share = 0.5,
                            .coefficients = {},
                            .bounds = {},
                            .principal_point = {}};
  const Pinhole camera = pinhole_from_hfov(160, 90, radians(80));
  int oversampled = 0;
  for (int view = 0; view < 12; ++view) {
    std::vector<DrawnLens> lenses = {undistorted_lens(camera)};
    for (int i = 0; i < 4; ++i)
      lenses.push_back(draw_lens(camera, CropOrder::label_first, options,
                                 substream(substream(make_stream(8, "lens"), view), i)));
    const Pinhole master_pinhole = shared_master(lenses, options.bounds.min_eigenvalue);
    double widest_fx = camera.fx;
    for (const DrawnLens& lens : lenses) widest_fx = std::min(widest_fx, lens.base.fx);
    CHECK(master_pinhole.fx >= 2 * widest_fx * (1 - 1e-12));
    oversampled += master_pinhole.fx > 2.001 * widest_fx;
    const OIIO::ImageBuf master = picture(master_pinhole);
    for (const DrawnLens& lens : lenses) {
      const Eigen::AlignedBox2d box = frame_on_plane(lens.base);
      // Coverage and resolution are asserted by the warp.
      const OIIO::ImageBuf shared =
          warp(master, master_pinhole, lens.distortion, lens.crop.camera, {.box = box});
      const Pinhole own_pinhole = master_camera(lens.base, WarpOptions{}, options.bounds.min_eigenvalue);
      const OIIO::ImageBuf own =
          warp(picture(own_pinhole), own_pinhole, lens.distortion, lens.crop.camera, {.box = box});
      for (int y = 0; y < camera.height; y += 5)
        for (int x = 0; x < camera.width; x += 5)
          REQUIRE(shared.getchannel(x, y, 0, 0) == Approx(own.getchannel(x, y, 0, 0)).margin(2e-4));
    }
  }
  CHECK(oversampled > 0);  // some view needs more than twofold
}
