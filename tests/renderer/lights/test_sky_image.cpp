#include <OpenImageIO/imagebuf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "random/counter_hash.h"
#include "renderer/lights/sky_models.h"
#include "tests/renderer/statistics.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

using std::numbers::pi;

/// An equirectangular picture and its temporary file.
struct Picture {
  TemporaryFolder folder;
  std::filesystem::path file = folder.path / "sky.exr";
  OIIO::ImageBuf pixels;
  Picture(int width, int height) : pixels(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)) {}
  void set(int x, int y, const Color& c) { pixels.setpixel(x, y, c.data()); }
  Daylight daylight() const {
    pixels.write(file.string());
    return {.sky = SkyModel::image, .sky_image = file};
  }
};

Vec3 direction(double azimuth_deg, double elevation_deg) {
  return direction_to_sun({.sun_elevation_deg = elevation_deg, .sun_azimuth_deg = azimuth_deg});
}

}  // namespace

TEST_CASE("The picture's middle is the horizon in the north, its right the east, its top overhead") {
  Picture picture(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x)
      picture.set(x, y, Color(static_cast<float>(x) + 0.5f, 31.5f - static_cast<float>(y), 1));
  }
  Daylight daylight = picture.daylight();
  daylight.sky_image_scale = 2;
  const Sky sky = make_image_sky(daylight);
  const auto at = [&](double azimuth, double elevation) -> Color {
    return sky.radiance(direction(azimuth, elevation)) / 2;
  };
  CHECK(at(0, 0).x() == Approx(32).margin(0.01));
  CHECK(at(90, 0).x() == Approx(48).margin(0.01));
  CHECK(at(-90, 30).x() == Approx(16).margin(0.01));
  CHECK(at(10, 0).y() == Approx(16).margin(0.01));
  CHECK(at(10, 45).y() == Approx(24).margin(0.01));
  CHECK(at(10, -45).y() == Approx(8).margin(0.01));

  daylight.sky_image_azimuth_deg = 75;  // not by whole texels
  const Sky turned = make_image_sky(daylight);
  for (double azimuth : {0.0, 75.0, 120.0}) {
    CHECK(turned.radiance(direction(azimuth, 20)).x() / 2 == Approx(at(azimuth - 75, 20).x()).margin(0.01));
  }
}

TEST_CASE("A bright spot of a picture is found by its light, and gives all of it") {
  // A sun of one texel in a dim, uneven sky.
  Picture picture(256, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) picture.set(x, y, Color::Constant(y < 64 ? 1.0f : 0.3f));
  }
  picture.set(150, 30, Color::Constant(20000));
  const Sky sky = make_image_sky(picture.daylight());
  REQUIRE_FALSE(sky.distribution.empty());

  constexpr int rows = 24, columns = 32, samples = 200000, fine = 128;
  std::vector<double> observed(rows * columns), expected(rows * columns);
  const auto cell_of = [&](const Vec3& d) {
    const int row = std::min(static_cast<int>((0.5f + 0.5f * d.y()) * rows), rows - 1);
    return row * columns + std::min(static_cast<int>(turns_of_vector(d.x(), d.z()) * columns), columns - 1);
  };
  const Stream stream = make_stream(5, "picture of the sky");
  double light = 0;
  for (int i = 0; i < samples; ++i) {
    const DirectionSample s =
        sky.distribution.sample({static_cast<float>(random_uniform(stream, 2 * i)),
                                 static_cast<float>(random_uniform(stream, 2 * i + 1))});
    ++observed[cell_of(s.direction)];
    light += luminance(sky.radiance(s.direction)) / s.pdf / samples;
  }
  for (int row = 0; row < rows * fine; ++row) {
    for (int column = 0; column < columns * fine; ++column) {
      const Vec3 d = direction_at((static_cast<float>(column) + 0.5f) / (columns * fine),
                                  2 * (static_cast<float>(row) + 0.5f) / (rows * fine) - 1);
      expected[cell_of(d)] += samples * sky.distribution.pdf(d) * 4 * pi / (rows * columns * fine * fine);
    }
  }
  CHECK(chi_squared_p_value(observed, expected) > 1e-4);
  const double elevation = (64 - 30.5) * pi / 128, texel_sr = std::cos(elevation) * (pi / 128) * (pi / 128);
  CHECK(light == Approx(20000 * texel_sr).epsilon(0.1));
}

TEST_CASE("Pictures that cannot serve as a sky are named") {
  const auto refusal = [](const Daylight& daylight) -> std::string {
    try {
      make_image_sky(daylight);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal({.sky = SkyModel::image, .sky_image = "/nowhere/sky.hdr"})
            .starts_with("/nowhere/sky.hdr: cannot be read as a picture of the sky"));
  Picture picture(4, 2);
  picture.set(1, 1, Color::Constant(NAN));
  CHECK(refusal(picture.daylight()) == picture.file.string() + ": holds a value that is not finite");
  Picture wide(8200, 2);
  CHECK(refusal(wide.daylight()) ==
        wide.file.string() + ": is 8200x2: a picture of the sky may be 2x2 to 8192x4096");
}
