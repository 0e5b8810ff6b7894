#include <OpenImageIO/imagebuf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>

#include "cps_program.h"
#include "dataset/exchange/calibration_file.h"
#include "dataset/files.h"
#include "random/counter_hash.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// A picture from a function of column, row and channel; integers as fractions of their largest value.
void write_image(const fs::path& file, int width, int height, int channels, OIIO::TypeDesc type,
                 const std::function<double(int x, int y, int channel)>& value) {
  fs::create_directories(file.parent_path());
  OIIO::ImageSpec spec(width, height, channels, type);
  if (channels == 2) spec.channelnames = {"Y", "A"}, spec.alpha_channel = 1;
  if (channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf image(spec);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        std::vector<float> pixel(channels);
        image.getpixel(x, y, pixel.data());
        pixel[c] = float(value(x, y, c));
        image.setpixel(x, y, pixel.data());
      }
  REQUIRE(image.write(file.string(), type));
}

OIIO::ImageBuf read_image(const fs::path& file) {
  OIIO::ImageSpec keep_alpha;
  keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf image(file.string(), 0, 0, nullptr, &keep_alpha);
  INFO(file);
  REQUIRE(image.read(0, 0, true));
  return image;
}

double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double noise(int x, int y, int c) {
  return random_uniform(make_stream(51, "noise"), (std::uint64_t(y) * 1000 + x) * 4 + c);
}

const CalibratedCamera barrel{
    "cam", {160, 100, 100, 101, 82, 47}, {.k1 = -0.18, .k2 = 0.03, .p1 = 0.002, .p2 = -0.003}};

fs::path write_barrel(const fs::path& folder) {
  write_calibration(folder / "barrel.yml", CalibrationFormat::opencv_yaml, std::vector{barrel});
  return folder / "barrel.yml";
}

void run_well(const std::string& arguments) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments << "\n" << run.output);
  REQUIRE(run.exit_status == 0);
}

CalibratedCamera label(const fs::path& file) {
  return read_calibration(file).front();
}

}  // namespace

TEST_CASE("undistort --keep camera has the geometry of OpenCV's initUndistortRectifyMap") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.exr", out = folder.path / "b.exr";
  // Each pixel says where it is; the mean of a ramp is the position that the kernel is centred on, but for
  // its ripple.
  write_image(in, 160, 100, 3, OIIO::TypeFloat, [](int x, int y, int c) {
    return c == 0 ? x : c == 1 ? y : 1;
  });
  run_well("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string() +
           " --keep camera --sigma 1");
  CHECK(label(folder.path / "b_calibration.json").camera == barrel.camera);
  CHECK(label(folder.path / "b_calibration.json").distortion == Distortion{});

  cv::Mat map_x, map_y;
  const cv::Matx33d k(100, 0, 82, 0, 101, 47, 0, 0, 1);
  const Distortion& d = barrel.distortion;
  cv::initUndistortRectifyMap(k, cv::Matx<double, 1, 5>(d.k1, d.k2, d.p1, d.p2, d.k3), cv::noArray(), k,
                              {160, 100}, CV_32F, map_x, map_y);
  const OIIO::ImageBuf image = read_image(out);
  int compared = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      if (image.getchannel(x, y, 0, 2) == 0) continue;
      ++compared;
      REQUIRE(image.getchannel(x, y, 0, 0) == Approx(map_x.at<float>(y, x)).margin(0.02));
      REQUIRE(image.getchannel(x, y, 0, 1) == Approx(map_y.at<float>(y, x)).margin(0.02));
    }
  CHECK(compared > 14000);
}

TEST_CASE("undistort keeps what it is told to") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png";
  write_image(in, 160, 100, 1, OIIO::TypeUInt8, [](int, int, int) { return 1; });
  const auto black_pixels = [&](const std::string& options) {
    run_well("undistort " + in.string() + " -o " + (folder.path / "b.png").string() + " --lens " +
             lens.string() + " " + options);
    const OIIO::ImageBuf image = read_image(folder.path / "b.png");
    int black = 0;
    for (int y = 0; y < image.spec().height; ++y)
      for (int x = 0; x < image.spec().width; ++x) {
        const float value = image.getchannel(x, y, 0, 0);
        CHECK((value == 0 || value == 1));
        black += value == 0;
      }
    return black;
  };
  CHECK(black_pixels("") == 0);
  const double valid_f = label(folder.path / "b_calibration.json").camera.fx;
  CHECK(black_pixels("--keep all --label-format opencv-xml") > 0);
  CHECK(label(folder.path / "b_calibration.xml").camera.fx < valid_f);
  CHECK(black_pixels("--hfov 100 --size 200x120") > 0);
  CHECK(label(folder.path / "b_calibration.json").camera == pinhole_from_hfov(200, 120, radians(100)));
}

TEST_CASE("distort and back returns the picture within the kernels' blur") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), ideal = folder.path / "ideal.png",
                 seen = folder.path / "seen.png", back = folder.path / "back.png";
  const auto wave = [](int x, int y) { return 0.5 + 0.2 * std::sin(x / 5.0) + 0.2 * std::cos(y / 4.0); };
  write_image(ideal, 320, 200, 3, OIIO::TypeUInt16, [&](int x, int y, int) { return wave(x, y); });
  run_well("distort " + ideal.string() + " -o " + seen.string() + " --hfov 110 --lens " + lens.string() +
           " --encoding linear --require-resolution --label-format ros --label " +
           (folder.path / "ros.yaml").string());
  const CalibratedCamera taken = label(folder.path / "ros.yaml");
  CHECK(taken.distortion == barrel.distortion);
  CHECK(taken.camera == barrel.camera);  // 110° at twice the size show enough
  run_well("undistort " + seen.string() + " -o " + back.string() + " --lens " +
           (folder.path / "ros.yaml").string() + " --hfov 110 --size 320x200 --encoding linear --sigma 0.5");
  const OIIO::ImageBuf image = read_image(back);
  REQUIRE(image.spec().format == OIIO::TypeUInt16);
  int compared = 0;
  double worst = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) {
      const double value = image.getchannel(x, y, 0, 1);
      if (value == 0) continue;
      ++compared;
      worst = std::max(worst, std::abs(value - wave(x, y)));
    }
  CHECK(compared > 20000);
  // Waves of 1/4 and 1/5 rad per pixel lose 1 − exp(−k²σ²/2) to a blur of σ ≤ 1.3 px; shifted by a pixel
  // they would differ by .09.
  CHECK(worst < 0.03);
}

TEST_CASE("integers are filtered as light: the mean of a checkerboard stays") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "a.png", out = folder.path / "b.png";
  for (const OIIO::TypeDesc& type : {OIIO::TypeUInt8, OIIO::TypeUInt16}) {
    write_image(in, 161, 101, 3, type, [](int x, int y, int) { return (x + y) % 2; });
    const auto mean = [&](const std::string& options, auto decode) {
      run_well("undistort " + in.string() + " -o " + out.string() + " --lens " +
               (folder.path / "none.yml").string() + " " + options);
      const OIIO::ImageBuf image = read_image(out);
      CHECK(image.spec().format == type);
      double sum = 0;
      for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 160; ++x) sum += decode(image.getchannel(x, y, 0, 1));
      return sum / 16000;
    };
    write_calibration(folder.path / "none.yml", CalibrationFormat::opencv_yaml,
                      std::vector<CalibratedCamera>{{"", {161, 101, 100, 100, 80, 50}, {}}});
    CHECK(mean("", linear) == Approx(0.5).margin(0.005));
    CHECK(mean("--encoding linear", [](double value) { return value; }) == Approx(0.5).margin(0.005));
    CHECK(mean("--encoding linear", linear) < 0.3);  // so the first check could fail
  }
}

TEST_CASE("pixel type, channels and format stay") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "in";
  const std::pair<std::string, OIIO::TypeDesc> kinds[] = {
      {"8.png", OIIO::TypeUInt8},   {"16.png", OIIO::TypeUInt16},   {"8.tif", OIIO::TypeUInt8},
      {"half.exr", OIIO::TypeHalf}, {"float.exr", OIIO::TypeFloat}, {"float.tif", OIIO::TypeFloat}};
  for (int channels = 1; channels <= 4; ++channels)
    for (const auto& [name, type] : kinds)
      write_image(in / "deep" / (std::to_string(channels) + name), 160, 100, channels, type, noise);
  write_image(in / "photo.jpg", 160, 100, 3, OIIO::TypeUInt8, noise);
  write_file(in / "notes.txt", std::string("not a picture"));
  run_well("undistort " + in.string() + " -o " + (folder.path / "out").string() + " --lens " + lens.string());
  int pictures = 0;
  for (const auto& entry : fs::recursive_directory_iterator(in)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".txt") continue;
    ++pictures;
    const OIIO::ImageBuf before = read_image(entry.path()),
                         after = read_image(folder.path / "out" / entry.path().lexically_relative(in));
    INFO(entry.path());
    CHECK(after.file_format_name() == before.file_format_name());
    CHECK(after.spec().format == before.spec().format);
    CHECK(after.spec().channelnames == before.spec().channelnames);
  }
  CHECK(pictures == 25);
  CHECK_FALSE(fs::exists(folder.path / "out" / "notes.txt"));
  CHECK(fs::exists(folder.path / "out" / "calibration.json"));
}

TEST_CASE("colour that nothing shows does not bleed into what alpha covers") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png", out = folder.path / "b.png";
  // Left: transparent, with red under it. Right: opaque green.
  write_image(in, 160, 100, 4, OIIO::TypeUInt8, [](int x, int, int c) {
    return x < 80 ? (c == 0 ? 1.0 : 0.0) : (c == 1 || c == 3 ? 1.0 : 0.0);
  });
  run_well("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string());
  const OIIO::ImageBuf image = read_image(out);
  int half_transparent = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      const float alpha = image.getchannel(x, y, 0, 3);
      half_transparent += alpha > 0.1 && alpha < 0.9;
      if (alpha > 0.1) CHECK(image.getchannel(x, y, 0, 0) == 0);
      if (alpha > 0.1) CHECK(image.getchannel(x, y, 0, 1) > 0.98);
    }
  CHECK(half_transparent > 50);
}

TEST_CASE("ids stay ids and depth is not mixed with nothing") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), ids = folder.path / "ids.png",
                 depth = folder.path / "depth.png", out = folder.path / "b.png";
  write_image(ids, 320, 200, 1, OIIO::TypeUInt16,
              [](int x, int y, int) { return ((x / 10) * 1000 + (y / 10) * 7 + 1) / 65535.0; });
  run_well("distort " + ids.string() + " -o " + out.string() + " --hfov 80 --resampling nearest --lens " +
           lens.string());
  const auto of_ids = label(folder.path / "b_calibration.json");
  const OIIO::ImageBuf found = read_image(out);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      const int id = *static_cast<const std::uint16_t*>(found.pixeladdr(x, y));
      REQUIRE(((id - 1) % 1000 % 7 == 0 && (id - 1) % 1000 / 7 < 20 && (id - 1) / 1000 < 32));
    }
  // A wall at 2000 mm; left of it nothing was measured.
  write_image(depth, 320, 200, 1, OIIO::TypeUInt16,
              [](int x, int, int) { return x < 160 ? 0 : 2000 / 65535.0; });
  run_well("distort " + depth.string() + " -o " + out.string() + " --hfov 80 --resampling depth --lens " +
           lens.string());
  CHECK(label(folder.path / "b_calibration.json") == of_ids);
  const OIIO::ImageBuf wall = read_image(out);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      const int z = *static_cast<const std::uint16_t*>(wall.pixeladdr(x, y));
      REQUIRE((z == 0 || z == 2000));
    }
}

TEST_CASE("distort zooms until no border is left, by the label, or is told not to") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png", out = folder.path / "b.png";
  write_image(in, 320, 200, 3, OIIO::TypeUInt8, [](int, int, int) { return 1; });
  const std::string common =
      "distort " + in.string() + " -o " + out.string() + " --hfov 60 --lens " + lens.string();
  run_well(common);
  const CalibratedCamera zoomed = label(folder.path / "b_calibration.json");
  CHECK(zoomed.camera.fx > barrel.camera.fx);
  CHECK(zoomed.camera.fy / zoomed.camera.fx == Approx(barrel.camera.fy / barrel.camera.fx));
  CHECK(zoomed.camera.cx == barrel.camera.cx);
  CHECK(zoomed.distortion == barrel.distortion);
  const OIIO::ImageBuf image = read_image(out);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) REQUIRE(image.getchannel(x, y, 0, 0) == 1);
  fs::remove(out);
  check_refused(common + " --max_zoom 1", 1, "wider source");
  check_refused(common + " --require-resolution --size 640x400", 1, "source pixels per axis");
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("distort draws the lens that lens sample lists") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "a.png", out = folder.path / "b.png";
  write_image(in, 256, 160, 3, OIIO::TypeUInt8, noise);
  run_well("distort " + in.string() + " -o " + out.string() +
           " --hfov 80 --size 128x80 --draw shape_prior --seed 5 --number 2");
  const CalibratedCamera drawn = label(folder.path / "b_calibration.json");
  CHECK(drawn.camera.width == 128);
  const nlohmann::json listed = nlohmann::json::parse(
      run_cps("lens sample 2 --size 128x80 --hfov 80 --seed 5 --lens_draw shape_prior --json").output)[1];
  CHECK(drawn.distortion.k1 == listed["k1"].get<double>());
  CHECK(drawn.distortion.p2 == listed["p2"].get<double>());
  CHECK(drawn.camera.cx == listed["cx"].get<double>());
  // Nearly: without a pad around the input, the kernel at the border needs a little more zoom.
  CHECK(drawn.camera.fx >= listed["f"].get<double>());
  CHECK(drawn.camera.fx < 1.06 * listed["f"].get<double>());
}

TEST_CASE("a bad file in a folder is named and costs no other") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "in", out = folder.path / "out";
  for (const char* name : {"1.png", "5.jpg", "9.png"})
    write_image(in / name, 160, 100, 3, OIIO::TypeUInt8, noise);
  write_image(in / "4.png", 80, 50, 3, OIIO::TypeUInt8, noise);
  const std::string png = read_file(in / "1.png"), jpeg = read_file(in / "5.jpg");
  write_file(in / "2.png", png.substr(0, png.size() / 2));
  write_file(in / "3.jpg", jpeg.substr(0, jpeg.size() / 2));
  write_file(in / "6.png", std::string("hello"));
  write_file(in / "7.exr", std::string());
  const ProgramRun run =
      run_cps("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string());
  INFO(run.output);
  CHECK(run.exit_status == 1);
  for (const char* name : {"2.png: is damaged", "3.jpg: is damaged", "4.png: is 80 x 50",
                           "6.png: is not a picture", "7.exr: is not a picture"})
    CHECK_THAT(run.output, Catch::Contains("cps: " + (in / name).string()));
  CHECK_THAT(run.output, Catch::Contains("3 pictures, 5 failed"));
  std::vector<std::string> made;
  for (const auto& entry : fs::directory_iterator(out)) made.push_back(entry.path().filename());
  CHECK_THAT(made,
             Catch::UnorderedEquals(std::vector<std::string>{"1.png", "5.jpg", "9.png", "calibration.json"}));
}

TEST_CASE("the same bytes for any number of threads") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "in";
  for (const char* name : {"1.png", "2.png", "3.png"})
    write_image(in / name, 160, 100, 3, OIIO::TypeUInt8, noise);
  for (const char* threads : {"1", "3"})
    run_well("undistort " + in.string() + " -o " + (folder.path / threads).string() + " --lens " +
             lens.string() + " --threads " + threads);
  for (const char* name : {"1.png", "2.png", "3.png"})
    CHECK(read_file(folder.path / "1" / name) == read_file(folder.path / "3" / name));
}

TEST_CASE("pictures of another size are refused, or their calibration is scaled") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png", out = folder.path / "b.png";
  write_image(in, 80, 50, 3, OIIO::TypeUInt8, noise);
  const std::string common = "undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string();
  CHECK(run_cps(common).exit_status == 1);
  run_well(common + " --rescale --keep camera");
  const Pinhole scaled = label(folder.path / "b_calibration.json").camera;
  CHECK(scaled.fx == barrel.camera.fx / 2);
  CHECK(scaled.cx == (barrel.camera.cx + 0.5) / 2 - 0.5);
}

TEST_CASE("distort and undistort refuse wrong usage and impossible things in one line") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png";
  write_image(in, 160, 100, 3, OIIO::TypeUInt8, noise);
  const std::string files = in.string() + " -o " + (folder.path / "b.png").string();
  const std::string with_lens = files + " --lens " + lens.string();
  check_refused("undistort " + files, 2, "--lens");
  check_refused("undistort " + in.string(), 2, "output");
  check_refused("undistort " + with_lens + " --keep most", 2, "valid, all, camera");
  check_refused("undistort " + with_lens + " --keep all --hfov 60", 2, "--keep or --hfov");
  check_refused("undistort " + with_lens + " --hfov 190", 2, "--hfov");
  check_refused("undistort " + with_lens + " --resampling cubic", 2, "footprint, nearest, depth");
  check_refused("undistort " + with_lens + " --encoding log", 2, "auto, srgb, linear");
  check_refused("undistort " + with_lens + " --label-format tum", 2, "opencv-yaml");
  check_refused("undistort " + with_lens + " --size big", 2, "--size big");
  check_refused("distort " + with_lens, 2, "--hfov DEG or --source");
  check_refused("distort " + with_lens + " --hfov 60 --draw sequential", 2, "--lens FILE or --draw");
  check_refused("distort " + with_lens + " --source " + lens.string(), 1, "straighten the input first");
  check_refused("distort " + files + " --hfov 60 --draw guess", 2, "--draw guess");
  check_refused("undistort /nonexistent -o b --lens " + lens.string(), 1, "/nonexistent");
  check_refused("undistort " + in.string() + " -o " + in.string() + " --lens " + lens.string(), 1,
                "is the input");
  check_refused("undistort " + folder.path.string() + " -o " + (folder.path / "out").string() + " --lens " +
                    lens.string(),
                1, "lies in the input folder");
  fs::create_directories(folder.path / "empty");
  check_refused("undistort " + (folder.path / "empty").string() + " -o /tmp/nowhere --lens " + lens.string(),
                1, "has no pictures");
  CHECK_FALSE(fs::exists(folder.path / "b.png"));
}
