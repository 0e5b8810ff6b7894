#include "files/files.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

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

TEST_CASE("pictures of another size are refused, or their calibration is scaled") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png", out = folder.path / "b.png";
  write_image(in, 80, 50, 3, OIIO::TypeUInt8, noise);
  const std::string common = "undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string();
  CHECK(run_cps(common).exit_status == 1);
  run_well(common + " --rescale --keep camera");
  const Pinhole scaled = label(folder.path / "b_calibration.json").pinhole;
  CHECK(scaled.fx == barrel.pinhole.fx / 2);
  CHECK(scaled.cx == (barrel.pinhole.cx + 0.5) / 2 - 0.5);
}

TEST_CASE("distort and undistort refuse wrong usage and impossible things in one line") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png";
  write_image(in, 160, 100, 3, OIIO::TypeUInt8, noise);
  const std::string files = in.string() + " -o " + (folder.path / "b.png").string();
  const std::string with_lens = files + " --lens " + lens.string();
  check_refused("undistort " + files, 2, "--lens");
  check_refused("undistort " + in.string(), 2, "--out");
  check_refused("undistort " + with_lens + " --keep most", 2, "valid, all, camera");
  check_refused("undistort " + with_lens + " --keep all --hfov 60", 2, "--keep or --hfov");
  check_refused("undistort " + with_lens + " --hfov 190", 2, "--hfov");
  check_refused("undistort " + with_lens + " --resampling cubic", 2, "footprint, nearest, depth");
  check_refused("undistort " + with_lens + " --encoding log", 2, "auto, srgb, linear");
  check_refused("undistort " + with_lens + " --label-format tum", 2, "opencv-yaml");
  check_refused("undistort " + with_lens + " --size big", 2, "--size big");
  check_refused("distort " + with_lens, 2, "--hfov DEG or --source");
  check_refused("distort " + with_lens + " --hfov 60 --draw sequential", 2, "--lens FILE or --lens_draw");
  check_refused("distort " + with_lens + " --source " + lens.string(), 1, "straighten the input first");
  check_refused("distort " + files + " --hfov 60 --draw guess", 2, "--lens_draw guess");
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
