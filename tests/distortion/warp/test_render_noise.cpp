#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/crop/crop.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/render_noise.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"
#include "tests/distortion/barrel.h"
#include "tests/distortion/random_lens.h"
#include "tests/distortion/warp/slow_warp.h"
#include "tests/same_bytes.h"

using namespace cps;

namespace {

/// A lens that enlarges the middle and shrinks the corners, its crop, and the camera of a master.
struct Barrel {
  Pinhole base = pinhole_from_hfov(200, 120, radians(90));
  Distortion lens = barrel(base);
  WarpOptions options{.box = frame_on_plane(base)};
  Crop crop = border_free_crop(lens, base, {base.cx, base.cy});
  Pinhole master = master_camera(base, options, crop.certificate.min_eigenvalue);

  /// Independent noise of variance `variance` about 1 in every pixel.
  OIIO::ImageBuf noise(double variance, int channels, Stream stream) const {
    OIIO::ImageBuf image(OIIO::ImageSpec(master.width, master.height, channels, OIIO::TypeFloat));
    auto* values = static_cast<float*>(image.localpixels());
    for (std::size_t i = 0; i < std::size_t(master.width) * master.height * channels; ++i)
      values[i] = float(1 + std::sqrt(variance) * random_normal(stream, i));
    return image;
  }
};

/// Statistics of noise in rings about the image's centre, from the most enlarged to the most shrunk.
struct Rings {
  static constexpr int count = 6;
  double squares[count]{}, products[count]{}, sums[count]{}, pixels[count]{};

  void add(const OIIO::ImageBuf& image, const Pinhole& camera) {
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x + 1 < camera.width; ++x) {
        const double radius = std::hypot(x - camera.cx, y - camera.cy) / std::hypot(camera.cx, camera.cy);
        const int ring = std::min(count - 1, int(radius * count));
        const double value = image.getchannel(x, y, 0, 0) - 1;
        squares[ring] += value * value;
        products[ring] += value * (image.getchannel(x + 1, y, 0, 0) - 1);
        sums[ring] += value;
        ++pixels[ring];
      }
  }
  double variance(int ring) const { return squares[ring] / pixels[ring]; }
  double neighbours(int ring) const { return products[ring] / squares[ring]; }
  double mean(int ring) const { return sums[ring] / pixels[ring]; }
};

}  // namespace

TEST_CASE("render noise has one level and one grain wherever the lens enlarges or shrinks") {
  const Barrel b;
  Rings even, uneven;
  for (int i = 0; i < 80; ++i) {
    const Stream stream = substream(make_stream(17, "noise"), i);
    const NoisyMaster master = join_halves(b.noise(2, 1, make_stream(stream.key, "first")),
                                           b.noise(2, 1, make_stream(stream.key, "second")));
    even.add(warp(master, b.master, b.lens, b.crop.camera, b.options), b.base);
    uneven.add(warp(master.picture, b.master, b.lens, b.crop.camera, b.options), b.base);
  }
  double variance = 0, neighbours = 0;
  for (int ring = 0; ring < Rings::count; ++ring) {
    variance += even.variance(ring) / Rings::count;
    neighbours += even.neighbours(ring) / Rings::count;
  }
  for (int ring = 0; ring < Rings::count; ++ring) {
    INFO("ring " << ring << ": variance " << even.variance(ring) << ", as rendered " << uneven.variance(ring)
                 << "; correlation of neighbours " << even.neighbours(ring) << ", "
                 << uneven.neighbours(ring));
    // Noise is correlated over about five pixels, so the smallest ring has 10,000 independent values: the
    // variance has a standard deviation of 1.4 %.
    CHECK(even.variance(ring) == Approx(variance).epsilon(0.05));
    CHECK(even.neighbours(ring) == Approx(neighbours).margin(0.015));
    CHECK(std::abs(even.mean(ring)) < 5 * std::sqrt(variance * 5 / even.pixels[ring]));
  }
  // g²/(4π(σ² − g²/12)) for a Gaussian kernel; the warp's differs a little.
  CHECK(variance == Approx(0.64 / (4 * 3.14159 * (0.25 - 0.64 / 12))).epsilon(0.15));
  CHECK(uneven.variance(0) > 2 * uneven.variance(Rings::count - 1));
}

TEST_CASE("the warp of a noisy master is what the derivation says, pixel by pixel") {
  const Stream stream = make_stream(20, "lenses");
  const std::pair<int, int> sizes[] = {{1, 1}, {65, 3}, {3, 130}, {96, 54}, {64, 64}};
  int lenses = 0;
  for (int i = 0; i < 60; ++i) {
    const Stream s = substream(stream, i);
    const auto [width, height] = sizes[i % std::size(sizes)];
    const int channels = 1 + i % 4;
    const Pinhole base = pinhole_from_hfov(width, height, radians(random_uniform(s, 0, 20, 140)));
    // Without a lens every fifth time, and then sometimes enlarged beyond where noise is added.
    const Distortion lens = i % 5 == 4 ? Distortion{} : random_lens(stream, i, base);
    const Crop crop = border_free_crop(lens, base, {base.cx + 0.01 * width, base.cy - 0.02 * height});
    if (!crop.valid) continue;
    Pinhole output = crop.camera;
    if (i % 5 == 4) output.fx *= 1 + 0.1 * (i % 9), output.fy = output.fx;
    const WarpOptions options{.box = frame_on_plane(base)};
    const Pinhole camera = master_camera(base, options, crop.certificate.min_eigenvalue);
    NoisyMaster master;
    for (OIIO::ImageBuf* image : {&master.picture, &master.noise}) {
      *image = OIIO::ImageBuf(OIIO::ImageSpec(camera.width, camera.height, channels, OIIO::TypeFloat));
      auto* values = static_cast<float*>(image->localpixels());
      const Stream pixels = make_stream(s.key, image == &master.noise ? "noise" : "picture");
      for (std::size_t k = 0; k < std::size_t(camera.width) * camera.height * channels; ++k)
        values[k] = float(random_normal(pixels, k));
    }
    const OIIO::ImageBuf image = warp(master, camera, lens, output, options);
    for (int k = 0; k < std::min(200, width * height); ++k) {
      const int x = int(random_below(s, 100 + 2 * k, width)), y = int(random_below(s, 101 + 2 * k, height));
      const Channels expected = slow_warp_pixel(master.picture, master.noise, camera, lens, options.box,
                                                output, options.kernel_sigma_px, {x, y});
      INFO("lens " << i << ", pixel (" << x << ", " << y << ") of " << width << " x " << height);
      for (int c = 0; c < channels; ++c)
        REQUIRE(image.getchannel(x, y, 0, c) == Approx(expected[c]).margin(2e-5));
    }
    ++lenses;
  }
  CHECK(lenses > 30);
}

TEST_CASE("a noisy master gives the same bytes for any number of threads") {
  const Barrel b;
  const Stream stream = make_stream(21, "picture");
  const NoisyMaster master = join_halves(b.noise(1, 3, make_stream(stream.key, "first")),
                                         b.noise(1, 3, make_stream(stream.key, "second")));
  std::vector<OIIO::ImageBuf> images;
  for (const int threads : {1, 2, 7}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    images.push_back(warp(master, b.master, b.lens, b.crop.camera, b.options));
  }
  for (int i = 1; i < 3; ++i) CHECK(same_bytes(images[0], images[i]));
}

TEST_CASE("where no noise can be added, the picture stays as it is") {
  const Barrel b;
  // Enlarged by 1.7, a master pixel is larger than the grain that noise is brought to.
  const Pinhole camera = master_camera(b.base, {}, 1);
  Pinhole close = b.base;
  close.fx = close.fy = 1.7 * b.base.fx;
  Barrel undistorted;
  undistorted.master = camera;
  const Stream stream = make_stream(22, "picture");
  const NoisyMaster master = join_halves(undistorted.noise(1, 2, make_stream(stream.key, "first")),
                                         undistorted.noise(1, 2, make_stream(stream.key, "second")));
  const auto image = warp(master, camera, {}, close), picture = warp(master.picture, camera, {}, close);
  CHECK(same_bytes(image, picture));
}

TEST_CASE("equal halves give the warp of their mean") {
  const Barrel b;
  const Stream stream = make_stream(18, "picture");
  const OIIO::ImageBuf half = b.noise(0.1, 3, stream);
  const auto image = warp(join_halves(half, half), b.master, b.lens, b.crop.camera, b.options);
  const auto expected = warp(half, b.master, b.lens, b.crop.camera, b.options);
  for (int y = 0; y < b.base.height; ++y)
    for (int x = 0; x < b.base.width; ++x)
      for (int c = 0; c < 3; ++c)
        REQUIRE(image.getchannel(x, y, 0, c) == Approx(expected.getchannel(x, y, 0, c)).epsilon(1e-6));
}

TEST_CASE("halves of different sizes, and resampling that cannot average, are refused") {
  const Barrel b;
  const Stream stream = make_stream(19, "picture");
  CHECK_THROWS_WITH(join_halves(b.noise(1, 1, stream), b.noise(1, 3, stream)),
                    Catch::Contains("halves differ"));
  const NoisyMaster master = join_halves(b.noise(1, 1, stream), b.noise(1, 1, stream));
  WarpOptions options = b.options;
  options.resampling = Resampling::nearest;
  CHECK_THROWS_WITH(warp(master, b.master, b.lens, b.crop.camera, options), Catch::Contains("averaged"));
  NoisyMaster other_channels{b.noise(1, 3, stream), b.noise(1, 1, stream)};
  CHECK_THROWS_WITH(warp(other_channels, b.master, b.lens, b.crop.camera, b.options),
                    Catch::Contains("channels"));
  NoisyMaster other_size{b.noise(1, 1, stream), OIIO::ImageBuf(OIIO::ImageSpec(9, 9, 1, OIIO::TypeFloat))};
  CHECK_THROWS_WITH(warp(other_size, b.master, b.lens, b.crop.camera, b.options), Catch::Contains("9 x 9"));
  CHECK_THROWS_WITH(
      warp({b.noise(1, 1, stream), OIIO::ImageBuf()}, b.master, b.lens, b.crop.camera, b.options),
      Catch::Contains("channels"));
}
