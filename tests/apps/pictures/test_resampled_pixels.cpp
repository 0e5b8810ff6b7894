#include "files/files.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

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
    CHECK(mean("--encoding linear", linear) < 0.3);  // shows that the first check can fail
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
  // A wall at 2000 mm; 0, not measured, left of it.
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
