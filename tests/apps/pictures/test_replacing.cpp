#include "files/files.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

struct Photos {
  TemporaryFolder folder;
  fs::path in = folder.path / "in", out = folder.path / "out", lens;
  Photos() {
    lens = write_barrel(folder.path);
    for (const char* name : {"1.png", "2.png"}) write_image(in / name, 160, 100, 3, OIIO::TypeUInt8, noise);
  }
  std::string command(const fs::path& output) const {
    return "undistort " + in.string() + " -o " + output.string() + " --lens " + lens.string();
  }
};

}  // namespace

TEST_CASE("no output replaces an input") {
  const Photos photos;
  const std::string lens_text = read_file(photos.lens);
  // The label's usual name in that format is the name of the lens file.
  fs::rename(photos.lens, photos.folder.path / "calibration.yml");
  const fs::path lens = photos.folder.path / "calibration.yml";
  const std::string here = "undistort " + photos.in.string() + " -o " + photos.folder.path.string() +
                           " --label-format opencv-yaml --lens " + lens.string();
  check_refused(here, 1, "is an input and would be replaced");
  CHECK(read_file(lens) == lens_text);
  CHECK_FALSE(fs::exists(photos.folder.path / "1.png"));
  // By another path, and by a hard link.
  fs::create_directories(photos.out);
  fs::create_hard_link(photos.in / "1.png", photos.out / "1.png");
  const std::string to_out =
      "undistort " + photos.in.string() + " -o " + photos.out.string() + " --lens " + lens.string();
  check_refused(to_out, 1, "is an input");
  fs::remove(photos.out / "1.png");
  check_refused(to_out + " --label " + (photos.out / "../in/2.png").string(), 1, "is an input");
  check_refused(to_out + " --label " + (photos.out / "1.png").string(), 1, "would be written twice");
  CHECK(fs::is_empty(photos.out));
  run_well(to_out);
  CHECK(fs::exists(photos.out / "calibration.json"));
}

TEST_CASE("a rerun that fails leaves no older picture under a new label") {
  const Photos photos;
  run_well(photos.command(photos.out));
  CHECK(fs::exists(photos.out / "calibration.json"));
  write_file(photos.in / "2.png", std::string("damaged"));
  const ProgramRun run = run_cps(photos.command(photos.out) + " --keep all");
  INFO(run.output);
  CHECK(run.exit_status == 1);
  CHECK_THAT(run.output, Catch::Contains("of an earlier run"));
  CHECK_FALSE(fs::exists(photos.out / "calibration.json"));
  // With the older picture gone, those that could be made have their label.
  fs::remove(photos.out / "2.png");
  CHECK(run_cps(photos.command(photos.out) + " --keep all").exit_status == 1);
  CHECK(fs::exists(photos.out / "calibration.json"));
}

TEST_CASE("nothing made, no label") {
  const Photos photos;
  for (const char* name : {"1.png", "2.png"}) write_file(photos.in / name, std::string("damaged"));
  CHECK(run_cps(photos.command(photos.out)).exit_status == 1);
  CHECK_FALSE(fs::exists(photos.out / "calibration.json"));
}

TEST_CASE("sizes that no memory holds and other shapes are refused") {
  const Photos photos;
  for (const char* size : {"100000x100000", "0x10", "-4x10", "10"})
    check_refused(photos.command(photos.out) + " --size=" + size, 2, "--size");
  write_image(photos.in / "1.png", 160, 90, 3, OIIO::TypeUInt8, noise);
  check_refused(photos.command(photos.out) + " --rescale", 1, "another shape");
  write_image(photos.in / "1.png", 320, 200, 3, OIIO::TypeUInt8, noise);
  write_image(photos.in / "2.png", 320, 200, 3, OIIO::TypeUInt8, noise);
  run_well(photos.command(photos.out) + " --rescale");
}

TEST_CASE("a folder's other kinds are named, and its links followed once") {
  const Photos photos;
  fs::create_directories(photos.folder.path / "elsewhere");
  fs::rename(photos.in / "2.png", photos.folder.path / "elsewhere" / "3.png");
  fs::create_directory_symlink(photos.folder.path / "elsewhere", photos.in / "more");
  fs::create_directory_symlink(photos.in, photos.folder.path / "elsewhere" / "back");
  write_file(photos.in / "moving.gif", std::string("GIF89a"));
  const ProgramRun run = run_cps(photos.command(photos.out));
  INFO(run.output);
  CHECK(run.exit_status == 0);
  CHECK_THAT(run.output, Catch::Contains("1 .gif left out"));
  CHECK(fs::exists(photos.out / "1.png"));
  CHECK(fs::exists(photos.out / "more" / "3.png"));
}
