#include <catch2/catch.hpp>

#include "dataset/exchange/camera_pictures.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("labels of pixels beside a dataset's images are not taken for pictures") {
  const TemporaryFolder folder;
  for (const char* name : {"000017.png", "000002.png", "000017.instance.png", "000017.semantic.png",
                           "000017.depth.exr", "valid.png", "calibration.json", "000003.JPG"})
    write_file(folder.path / name, std::string_view("x"));
  CHECK(pictures_in(folder.path) ==
        std::vector{folder.path / "000002.png", folder.path / "000003.JPG", folder.path / "000017.png"});
}

TEST_CASE("pictures whose names only look like labels are pictures") {
  const TemporaryFolder folder;
  for (const char* name : {"valid.png", "semantic.png", "drive.instances.png", "a.depth.png"})
    write_file(folder.path / name, std::string_view("x"));
  CHECK(pictures_in(folder.path).size() == 4);
  CHECK_THROWS_WITH(pictures_in(folder.path / "none"), Catch::Contains("is not a folder of pictures"));
  fs::create_directory(folder.path / "labels");
  write_file(folder.path / "labels/000001.instance.png", std::string_view("x"));
  CHECK_THROWS_WITH(pictures_in(folder.path / "labels"), Catch::Contains("has no pictures in it"));
}
