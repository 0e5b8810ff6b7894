#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/crop/crop.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"
#include "tests/apps/cps_program.h"
#include "tests/distortion/warp/dense_rays.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int fineness = 8;  ///< rendered pixels per master pixel and axis

/// The green of a rendered picture as the sensor sees it: white is five times the mean, brighter is clipped.
std::vector<float> exposed(const OIIO::ImageBuf& picture) {
  const int width = picture.spec().width, height = picture.spec().height;
  std::vector<float> green(std::size_t(width) * height);
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      green[std::size_t(y) * width + x] = picture.getchannel(x, y, 0, 1);
      sum += std::min(1e3f, picture.getchannel(x, y, 0, 1));
    }
  const float white = float(5 * sum / double(green.size()));
  for (float& value : green) value = std::min(1.0f, value / white);
  return green;
}

}  // namespace

TEST_CASE("the warp of a rendered street agrees with dense rays to 40 dB", "[slow]") {
  const TemporaryFolder folder;
  const std::string city = (folder.path / "city.glb").string(), exr = (folder.path / "street.exr").string();
  REQUIRE(run_cps("city --seed 1 --extent-m 300 -o " + city).exit_status == 0);

  // A master of 2×, and the street behind it rendered eight times as fine: every fine pixel is one of the
  // scene's squares of constant colour, and the master's pixels are exact means of them.
  const Pinhole base = pinhole_from_hfov(160, 90, radians(80));
  const WarpOptions options;
  const Pinhole master = master_camera(base, options, 0.15), fine = oversampled(master, fineness);
  const ProgramRun rendered =
      run_cps("render " + city + " -o " + exr + " --samples 2 --size " + std::to_string(fine.width) + "x" +
              std::to_string(fine.height) + " --hfov " + std::to_string(degrees(hfov_rad(fine))));
  INFO(rendered.output);
  REQUIRE(rendered.exit_status == 0);
  OIIO::ImageBuf picture(exr);
  REQUIRE(picture.read(0, 0, true, OIIO::TypeFloat));
  const std::vector<float> green = exposed(picture);
  const auto street = [&](const Eigen::Vector2d& ideal) {
    const Eigen::Vector2d pixel = to_pixel(fine, ideal);
    const int x = std::clamp(int(std::floor(pixel.x() + 0.5)), 0, fine.width - 1);
    const int y = std::clamp(int(std::floor(pixel.y() + 0.5)), 0, fine.height - 1);
    return green[std::size_t(y) * fine.width + x];
  };
  const OIIO::ImageBuf master_image = render_analytic(street, master, fineness);

  const double unit = 1 / (0.5 * frame_on_plane(base).diagonal().norm());
  for (const Distortion& scaled : {Distortion{}, Distortion{-0.372, 0.203, -0.071, 0.002, -0.001},
                                   Distortion{0.15, 0.02, -0.01, 0.003, 0.002}}) {
    const Distortion lens = rescaled(scaled, unit);
    const Crop crop = border_free_crop(lens, base, {base.cx + 3.3, base.cy - 2.1});
    REQUIRE(crop.valid);
    const OIIO::ImageBuf image = warp(master_image, master, lens, crop.camera, options);
    double squared = 0;
    int count = 0;
    for (int y = 1; y < base.height; y += 2)
      for (int x = 1; x < base.width; x += 2, ++count) {
        const double expected = reference_pixel(street, lens, frame_on_plane(master), crop.camera,
                                                options.kernel_sigma_px, {x, y}, 60);
        squared += std::pow(image.getchannel(x, y, 0, 0) - expected, 2);
      }
    const double psnr = -10 * std::log10(squared / count);
    WARN("street, k1 " << scaled.k1 << ": " << psnr << " dB");
    CHECK(psnr > 40);
  }
}
