#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "distortion/warp/gather.h"
#include "random/counter_hash.h"
#include "tests/distortion/warp/slow_warp.h"

using namespace cps;

namespace {

OIIO::ImageBuf random_image(int width, int height, int channels, Stream stream,
                            OIIO::TypeDesc type = OIIO::TypeFloat) {
  OIIO::ImageBuf image(OIIO::ImageSpec(width, height, channels, type));
  std::array<float, 4> pixel;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c)
        pixel[c] = float(random_uniform(stream, (std::uint64_t(y) * width + x) * channels + c));
      image.setpixel(x, y, pixel.data());
    }
  return image;
}

/// A tile of one row with the footprints of a linear map; those of real lenses are linear over their kernel.
void set_footprint(FootprintTile& tile, int i, const Eigen::Vector2d& centre,
                   const Eigen::Matrix2d& covariance) {
  tile.x[i] = centre.x();
  tile.y[i] = centre.y();
  set_kernel(tile.kernels[0], i, covariance);
}

}  // namespace

TEST_CASE("gathered pixels are the kernel's means, whatever the kernel's size, shape and place") {
  const Stream stream = make_stream(33, "footprints");
  const auto tile = std::make_unique<FootprintTile>();
  tile->height = 1;
  int covered = 0, uncovered = 0, wider_than_a_tile = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Stream s = substream(stream, trial);
    const int channels = 1 + trial % 4;
    const int width = 4 + int(random_below(s, 0, 200)), height = 4 + int(random_below(s, 1, 200));
    const OIIO::ImageBuf image = random_image(width, height, channels, make_stream(s.key, "pixels"));
    tile->width = 1 + int(random_below(s, 2, trial % 3 ? 8 : FootprintTile::side));
    std::vector<Eigen::Vector2d> centres;
    std::vector<Eigen::Matrix2d> covariances;
    for (int i = 0; i < tile->width; ++i) {
      const Stream of_pixel = substream(s, i);
      centres.emplace_back(random_uniform(of_pixel, 0, -1, width), random_uniform(of_pixel, 1, -1, height));
      const double widest = trial % 5 ? 3 : 20;
      const Eigen::Vector2d sigma(random_uniform(of_pixel, 2, narrowest_sigma_px, widest),
                                  random_uniform(of_pixel, 3, narrowest_sigma_px, widest));
      const Eigen::Rotation2Dd turn(random_uniform(of_pixel, 4, 0, 3));
      covariances.push_back(turn.toRotationMatrix() * sigma.cwiseAbs2().asDiagonal() *
                            turn.toRotationMatrix().transpose());
      set_footprint(*tile, i, centres.back(), covariances.back());
    }
    BoundsRow bounds;
    const int missing = find_bounds(*tile, 0, width, height, bounds);
    PlanarPatch patch;
    read_patch(image, common_bounds({&bounds, 1}, tile->width), patch);
    std::vector<float> pixels(tile->width * channels);
    gather_row(patch, {tile->x.data(), tile->y.data(), tile->kernels[0], bounds}, tile->width, pixels.data());

    int found_missing = 0;
    for (int i = 0; i < tile->width; ++i) {
      const Eigen::Vector2d reach = kernel_support * covariances[i].diagonal().cwiseSqrt();
      const bool inside = centres[i].x() - reach.x() > -1 && centres[i].x() + reach.x() < width &&
                          centres[i].y() - reach.y() > -1 && centres[i].y() + reach.y() < height;
      INFO("trial " << trial << ", pixel " << i << " at " << centres[i].transpose() << " of " << width
                    << " x " << height << ": " << covariances[i]);
      REQUIRE((bounds.x0[i] >= 0) == inside);
      if (inside) {
        const Channels expected = slow_gather(image, centres[i], covariances[i]);
        for (int c = 0; c < channels; ++c)
          REQUIRE(pixels[i * channels + c] == Approx(expected[c]).epsilon(1e-5));
        wider_than_a_tile += bounds.x1[i] - bounds.x0[i] >= FootprintTile::side;
        ++covered;
      } else {
        for (int c = 0; c < channels; ++c) REQUIRE(pixels[i * channels + c] == 0);
        ++found_missing;
      }
    }
    CHECK(missing == found_missing);
    uncovered += missing;
  }
  CHECK(covered > 500);
  CHECK(uncovered > 500);
  CHECK(wider_than_a_tile > 5);
}

TEST_CASE("a ray that misses the source, or lies too far for a whole number, has no bounds") {
  const auto tile = std::make_unique<FootprintTile>();
  tile->width = 5;
  tile->height = 1;
  const double far[] = {std::nan(""), 1e300, -1e300, 3e9, HUGE_VAL};
  for (int i = 0; i < 5; ++i) set_footprint(*tile, i, {far[i], 3}, Eigen::Matrix2d::Identity());
  BoundsRow bounds;
  CHECK(find_bounds(*tile, 0, 100, 100, bounds) == 5);
  for (int i = 0; i < 5; ++i) CHECK(bounds.x0[i] == -1);
  CHECK(common_bounds({&bounds, 1}, 5).width == 0);
}

TEST_CASE("a patch is the image's rectangle in planes, whatever the pixel type") {
  const Stream stream = make_stream(34, "patch");
  for (const OIIO::TypeDesc& type : {OIIO::TypeFloat, OIIO::TypeHalf, OIIO::TypeUInt8})
    for (int channels = 1; channels <= 4; ++channels) {
      const OIIO::ImageBuf image = random_image(37, 21, channels, stream, type);
      PlanarPatch patch;
      read_patch(image, {0, 0, 37, 21}, patch);
      for (const TileRect rect : {TileRect{3, 5, 29, 11}, TileRect{36, 20, 1, 1}, TileRect{0, 0, 37, 1}}) {
        read_patch(image, rect, patch);  // over what the last one left
        for (int c = 0; c < channels; ++c)
          for (int y = rect.y0; y < rect.y0 + rect.height; ++y) {
            for (int x = 0; x < rect.width; ++x)
              REQUIRE(patch.row(c, y)[x] == image.getchannel(rect.x0 + x, y, 0, c));
            for (int x = rect.width; x < int(patch.stride); ++x) REQUIRE(patch.row(c, y)[x] == 0);
          }
      }
    }
}
