#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/images/augmentation.h"
#include "trainer/images/corruptions.h"

using namespace cps;

namespace {

/// One bright pixel on black.
GrayImage spot(int x, int y) {
  GrayImage image{{41, 31}, std::vector<std::uint8_t>(41 * 31, 0)};
  image.pixels[y * 41 + x] = 255;
  return image;
}

struct Moments {
  double sum = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
};

Moments moments(const GrayImage& image) {
  Moments m;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      const double v = image.pixels[y * image.size.width + x];
      m.sum += v;
      m.x += v * x;
      m.y += v * y;
    }
  m.x /= m.sum;
  m.y /= m.sum;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      const double v = image.pixels[y * image.size.width + x] / m.sum;
      m.xx += v * (x - m.x) * (x - m.x);
      m.yy += v * (y - m.y) * (y - m.y);
      m.xy += v * (x - m.x) * (y - m.y);
    }
  return m;
}

GrayImage flat(std::uint8_t value) {
  return {{64, 48}, std::vector<std::uint8_t>(64 * 48, value)};
}

GrayImage corruption_street() {
  return render_street(draw_calibration({96, 54}, 70, 3), 5);
}

}  // namespace

TEST_CASE("blur has the spread it is asked for and moves nothing") {
  GrayImage image = spot(20, 15);
  for (int i = 0; i < 12; ++i) image.pixels[15 * 41 + 15 + i] = 255;  // more light, less rounding
  const Moments before = moments(image);
  blur(image, 1.5);
  const Moments after = moments(image);
  CHECK(after.x == Approx(before.x).margin(.02));
  CHECK(after.y == Approx(before.y).margin(.02));
  CHECK(after.yy - before.yy == Approx(1.5 * 1.5).epsilon(.08));
  GrayImage same = spot(3, 3);
  blur(same, 0);
  CHECK(same.pixels == spot(3, 3).pixels);
}

TEST_CASE("motion blur is a centred streak along its angle") {
  for (double angle : {0.0, .6, 1.9}) {
    GrayImage image = spot(20, 15);
    motion_blur(image, 9, angle);
    const Moments m = moments(image);
    CHECK(m.x == Approx(20).margin(.06));
    CHECK(m.y == Approx(15).margin(.06));
    // A streak's variance is L²/12 along it; bilinear sampling adds at most 1/4 a direction.
    const double along = std::cos(angle) * std::cos(angle) * m.xx + std::sin(angle) * std::sin(angle) * m.yy +
                         2 * std::sin(angle) * std::cos(angle) * m.xy;
    CHECK(along == Approx(81.0 / 12).margin(.45));
  }
}

TEST_CASE("gamma and contrast follow their formulas") {
  GrayImage image = flat(64);
  apply_gamma(image, 2);
  CHECK(image.pixels[0] == std::lround(64.0 * 64 / 255));
  apply_gamma(image, .5);
  CHECK(image.pixels[0] == Approx(64).margin(1));
  GrayImage contrast = flat(100);
  apply_contrast(contrast, 1.2, 10);
  CHECK(contrast.pixels[0] == std::lround(127.5 + 1.2 * (100 - 127.5) + 10));
  apply_contrast(contrast, 1, -255);
  CHECK(contrast.pixels[0] == 0);
}

TEST_CASE("ISO noise has mean zero and the documented variance") {
  for (int value : {60, 200}) {
    GrayImage image = flat(static_cast<std::uint8_t>(value));
    add_iso_noise(image, 10, make_stream(1, "noise"));
    double sum = 0, squares = 0;
    for (std::uint8_t v : image.pixels) sum += v;
    const double n = static_cast<double>(image.pixels.size()), mean = sum / n;
    for (std::uint8_t v : image.pixels) squares += (v - mean) * (v - mean);
    const double expected = 100 * (.2 + .8 * value / 255) + 1 / 12.0;
    CHECK(mean == Approx(value).margin(4 * std::sqrt(expected / n)));
    CHECK(squares / n == Approx(expected).epsilon(4 * std::sqrt(2 / n)));
  }
}

TEST_CASE("JPEG losses are libjpeg's") {
  const TemporaryFolder folder;
  const GrayImage original = corruption_street();
  for (int quality : {90, 50, 20}) {
    const std::string file = (folder.path / (std::to_string(quality) + ".jpg")).string();
    auto out = OIIO::ImageOutput::create(file);
    OIIO::ImageSpec spec(original.size.width, original.size.height, 1, OIIO::TypeDesc::UINT8);
    spec.attribute("Compression", "jpeg:" + std::to_string(quality));
    REQUIRE(out->open(file, spec));
    REQUIRE(out->write_image(OIIO::TypeDesc::UINT8, original.pixels.data()));
    out->close();
    const GrayImage theirs = read_gray_image(file);
    GrayImage ours = original;
    compress_as_jpeg(ours, quality);
    double difference = 0, losses = 0;
    for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
      difference += std::abs(int(ours.pixels[i]) - int(theirs.pixels[i]));
      losses += std::abs(int(original.pixels[i]) - int(theirs.pixels[i]));
    }
    INFO("quality " << quality << ": losses " << losses / double(ours.pixels.size()));
    CHECK(difference <
          .1 * losses + .05 * double(ours.pixels.size()));  // their transform is of whole numbers
  }
}

TEST_CASE("cutout hides one rectangle inside the image, no larger than allowed") {
  const GrayImage original = corruption_street();
  for (std::uint64_t i = 0; i < 50; ++i) {
    GrayImage image = original;
    cut_out(image, .25, make_stream(i, "cutout"));
    int x0 = 96, x1 = -1, y0 = 54, y1 = -1;
    for (int y = 0; y < 54; ++y)
      for (int x = 0; x < 96; ++x)
        if (image.pixels[y * 96 + x] != original.pixels[y * 96 + x]) {
          x0 = std::min(x0, x);
          x1 = std::max(x1, x);
          y0 = std::min(y0, y);
          y1 = std::max(y1, y);
        }
    CHECK(x1 - x0 + 1 <= 24);
    CHECK(y1 - y0 + 1 <= 14);
  }
}

TEST_CASE("an augmented image is a function of its stream, and each change comes as often as asked") {
  const GrayImage original = corruption_street();
  const GrayView view{original.size, original.pixels.data()};
  CHECK(augmented(view, {}, make_stream(1, "a")).pixels == original.pixels);
  const Augmentation often{.probability = .5};
  CHECK(augmented(view, often, make_stream(1, "a")).pixels ==
        augmented(view, often, make_stream(1, "a")).pixels);
  CHECK(augmented(view, often, make_stream(1, "a")).pixels !=
        augmented(view, often, make_stream(2, "a")).pixels);
  int untouched = 0;
  const int images = 2000;
  for (int i = 0; i < images; ++i)
    untouched += augmented(view, {.probability = .2}, make_stream(i, "b")).pixels == original.pixels;
  // Seven changes, of which each may also be too small to see.
  const double none = std::pow(.8, 7);
  CHECK(untouched > images * (none - 4 * std::sqrt(none * (1 - none) / images)));
  CHECK(untouched < images * (none + .06));
}

TEST_CASE("augmentation moves nothing: an edge stays where it is") {
  // The centre of a bright bar, under all changes at once except cutout, which would hide it.
  GrayImage bar{{61, 40}, std::vector<std::uint8_t>(61 * 40, 20)};
  for (int y = 0; y < 40; ++y)
    for (int x = 26; x <= 34; ++x) bar.pixels[y * 61 + x] = 200;
  const GrayView view{bar.size, bar.pixels.data()};
  const Augmentation all{.probability = 1, .max_iso_noise = 2, .max_cutout = 0};
  double shift = 0;
  const int images = 200;
  for (int i = 0; i < images; ++i) {
    const GrayImage seen = augmented(view, all, make_stream(i, "bar"));
    double sum = 0, x_sum = 0, least = 255;
    for (std::uint8_t v : seen.pixels) least = std::min<double>(least, v);
    for (int y = 8; y < 32; ++y)
      for (int x = 14; x < 47; ++x) {
        const double v = seen.pixels[y * 61 + x] - least;
        sum += v;
        x_sum += v * x;
      }
    if (sum > 0) shift += (x_sum / sum - 30) / images;
  }
  CHECK(shift == Approx(0).margin(.05));
}
