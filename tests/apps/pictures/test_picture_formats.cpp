#include "apps/pictures/jpeg_end.h"
#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_format.h"
#include "files/files.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int width = 48, height = 36;

/// A picture in memory, as read_picture() gives one.
Picture random_picture(OIIO::TypeDesc type, int channels, bool is_light) {
  Picture picture{.pixels = {}, .file = OIIO::ImageSpec(width, height, channels, type), .is_light = is_light};
  const OIIO::TypeDesc in_memory = is_light ? OIIO::TypeDesc(OIIO::TypeFloat) : type;
  picture.pixels.reset(OIIO::ImageSpec(width, height, channels, in_memory));
  picture.is_srgb = is_light && !type.is_floating_point();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::vector<float> pixel(channels);
      for (int c = 0; c < channels; ++c) pixel[c] = static_cast<float>(noise(x, y, c));
      picture.pixels.setpixel(x, y, pixel.data());
    }
  return picture;
}

bool are_bits_equal(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b) {
  const auto bytes = [](const OIIO::ImageBuf& image) {
    const auto* begin = static_cast<const char*>(image.localpixels());
    return std::string(begin, begin + image.spec().image_bytes());
  };
  return a.spec().format == b.spec().format && bytes(a) == bytes(b);
}

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

TEST_CASE("every format gives ids and depth back bit for bit in every pixel type, or refuses them") {
  const TemporaryFolder folder;
  const OIIO::TypeDesc types[] = {OIIO::TypeUInt8, OIIO::TypeUInt16, OIIO::TypeUInt32, OIIO::TypeHalf,
                                  OIIO::TypeFloat};
  int kept = 0, refused = 0;
  for (const PictureFormat& format : picture_formats())
    for (const char* extension : format.extensions)
      for (const OIIO::TypeDesc& type : types) {
        const fs::path file = folder.path / (std::string("ids") + extension);
        fs::remove(file);
        // .ppm has three channels, .pgm one.
        const Picture ids = random_picture(type, std::string(extension) == ".ppm" ? 3 : 1, false);
        INFO(file << " " << type.c_str());
        if (!format.is_lossless || !stored_type(format, type, false)) {
          CHECK_THROWS_WITH(write_picture(file, ids.pixels, ids), Catch::Contains(file.string()));
          CHECK_FALSE(fs::exists(file));
          ++refused;
        } else {
          write_picture(file, ids.pixels, ids);
          const Picture read = read_picture(file, Encoding::automatic, Resampling::nearest, width, height);
          CHECK(are_bits_equal(read.pixels, ids.pixels));
          ++kept;
        }
      }
  CHECK(kept > 20);
  CHECK(refused > 20);
}

TEST_CASE("every format shows light as it was, from whatever pixel type") {
  const TemporaryFolder folder;
  for (const PictureFormat& format : picture_formats())
    for (const char* extension : format.extensions)
      for (const OIIO::TypeDesc& type : {OIIO::TypeUInt8, OIIO::TypeHalf, OIIO::TypeFloat}) {
        const fs::path file = folder.path / (std::string("light") + extension);
        fs::remove(file);
        Picture gray = random_picture(type, std::string(extension) == ".pgm" ? 1 : 3, true);
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            for (int c = 0; c < gray.file.nchannels; ++c)
              static_cast<float*>(gray.pixels.pixeladdr(x, y))[c] = 0.2f + 0.015f * static_cast<float>(y);
        INFO(file << " " << type.c_str());
        write_picture(file, gray.pixels, gray);
        const Picture read = read_picture(file, Encoding::automatic, Resampling::footprint, width, height);
        CHECK(read.file.nchannels == gray.file.nchannels);
        for (int y = 0; y < height; ++y)
          CHECK(read.pixels.getchannel(20, y, 0, 0) ==
                Approx(0.2 + 0.015 * y).epsilon(format.is_lossless ? 0.01 : 0.06));
      }
}

TEST_CASE("encoding follows the format unless the user says otherwise") {
  const TemporaryFolder folder;
  const auto stored = [&](const fs::path& from, const fs::path& to, Encoding encoding) {
    const Picture picture = read_picture(folder.path / from, encoding, Resampling::footprint, width, height);
    write_picture(folder.path / to, picture.pixels, picture);
    return read_image(folder.path / to).getchannel(5, 5, 0, 0);
  };
  const auto constant = [](double value) { return [value](int, int, int) { return value; }; };
  write_image(folder.path / "half.exr", width, height, 3, OIIO::TypeHalf, constant(0.5));
  write_image(folder.path / "188.png", width, height, 3, OIIO::TypeUInt8, constant(188 / 255.0));
  const auto png = [](double value) { return Approx(value).margin(0.5 / 255 + 1e-6); };
  CHECK(stored("half.exr", "a.png", Encoding::automatic) == png(srgb(0.5)));
  CHECK(stored("188.png", "a.exr", Encoding::automatic) == Approx(linear(188 / 255.0)).epsilon(0.001));
  CHECK(stored("half.exr", "b.png", Encoding::linear) == png(0.5));
  CHECK(stored("188.png", "b.exr", Encoding::linear) == Approx(188 / 255.0).epsilon(0.001));
  CHECK(stored("half.exr", "c.png", Encoding::srgb) == png(0.5));
  CHECK(stored("a.png", "d.png", Encoding::automatic) == png(188 / 255.0));
}

TEST_CASE("alpha is straight in PNG and premultiplied in EXR, both ways") {
  const TemporaryFolder folder;
  const fs::path png = folder.path / "a.png", exr = folder.path / "a.exr", back = folder.path / "b.png";
  // Light .5 (188 encoded) behind a mask of .6.
  write_image(png, width, height, 4, OIIO::TypeUInt8,
              [](int, int, int c) { return c == 3 ? 0.6 : 188 / 255.0; });
  const auto convert = [](const fs::path& from, const fs::path& to) {
    const Picture picture = read_picture(from, Encoding::automatic, Resampling::footprint, width, height);
    write_picture(to, picture.pixels, picture);
    return read_image(to);
  };
  const OIIO::ImageBuf premultiplied = convert(png, exr), straight = convert(exr, back);
  CHECK(premultiplied.getchannel(3, 3, 0, 0) == Approx(0.6 * linear(188 / 255.0)).epsilon(0.002));
  CHECK(premultiplied.getchannel(3, 3, 0, 3) == Approx(0.6).epsilon(0.001));
  CHECK(straight.getchannel(3, 3, 0, 0) == Approx(188 / 255.0).margin(0.6 / 255));
  CHECK(straight.getchannel(3, 3, 0, 3) == Approx(0.6).margin(0.6 / 255));
}

TEST_CASE("formats without alpha or enough bits are refused, not thinned out") {
  const TemporaryFolder folder;
  const auto refused = [&](const char* name, OIIO::TypeDesc type, int channels) {
    const Picture picture = random_picture(type, channels, true);
    CHECK_THROWS_WITH(write_picture(folder.path / name, picture.pixels, picture),
                      Catch::Contains("no place for"));
    CHECK(fs::is_empty(folder.path));
  };
  refused("alpha.jpg", OIIO::TypeUInt8, 4);
  refused("deep.jpg", OIIO::TypeUInt16, 3);
  refused("deep.bmp", OIIO::TypeUInt16, 3);
  const Picture picture = random_picture(OIIO::TypeUInt8, 3, true);
  CHECK_THROWS_WITH(write_picture(folder.path / "a.gif", picture.pixels, picture),
                    Catch::Contains("writes no such format"));
}

TEST_CASE("what follows a JPEG's end is no damage, a cut before it is") {
  const TemporaryFolder folder;
  write_image(folder.path / "a.jpg", width, height, 3, OIIO::TypeUInt8, noise);
  const std::string jpeg = read_file(folder.path / "a.jpg");
  CHECK(has_whole_image(jpeg));
  CHECK(has_whole_image(jpeg + "a phone's notes"));
  CHECK(has_whole_image(jpeg + "\xff\xda and a start of scan"));
  CHECK(has_whole_image(jpeg + jpeg.substr(0, jpeg.size() / 2)));
  for (std::size_t size = 0; size < jpeg.size(); ++size) {
    INFO(size << " of " << jpeg.size());
    REQUIRE_FALSE(has_whole_image(jpeg.substr(0, size)));
  }
}
