#include "apps/pictures/picture_file.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int width = 12, height = 8;

/// Where a file of this EXIF orientation stores the upright picture's pixel (EXIF 2.3, tag 0x112: which side
/// of the picture the first row and the first column of the file are).
std::array<int, 2> stored_at(int orientation, int x, int y) {
  const int right = width - 1 - x, bottom = height - 1 - y;
  switch (orientation) {
    case 2:
      return {right, y};
    case 3:
      return {right, bottom};
    case 4:
      return {x, bottom};
    case 5:
      return {y, x};
    case 6:
      return {y, right};
    case 7:
      return {bottom, right};
    case 8:
      return {bottom, x};
    default:
      return {x, y};
  }
}

int id_at(int x, int y) {
  return 1 + x + width * y;
}

void write_turned(const fs::path& file, int orientation) {
  const bool is_on_its_side = orientation >= 5;
  OIIO::ImageSpec spec(is_on_its_side ? height : width, is_on_its_side ? width : height, 1, OIIO::TypeUInt8);
  spec.attribute("Orientation", orientation);
  OIIO::ImageBuf image(spec);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [column, row] = stored_at(orientation, x, y);
      *static_cast<std::uint8_t*>(image.pixeladdr(column, row)) = static_cast<std::uint8_t>(id_at(x, y));
    }
  REQUIRE(image.write(file.string()));
}

}  // namespace

TEST_CASE("pictures are read upright, whichever way the camera was held") {
  const TemporaryFolder folder;
  for (int orientation = 1; orientation <= 8; ++orientation) {
    INFO("orientation " << orientation);
    const fs::path file = folder.path / "a.tif", copy = folder.path / "b.tif";
    write_turned(file, orientation);
    CHECK(upright_size(file) == ImageSize{width, height});
    const Picture picture = read_picture(file, Encoding::automatic, Resampling::nearest, width, height);
    CHECK(picture.was_turned == (orientation != 1));
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        wrong += *static_cast<const std::uint8_t*>(picture.pixels.pixeladdr(x, y)) != id_at(x, y) ? 1 : 0;
    CHECK(wrong == 0);
    // Written upright, it is not turned again.
    write_picture(copy, picture.pixels, picture);
    CHECK_FALSE(read_picture(copy, Encoding::automatic, Resampling::nearest, width, height).was_turned);
  }
}

TEST_CASE("undistort says that it turned pictures, and which size it compares") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "in", out = folder.path / "out";
  fs::create_directories(in);
  OIIO::ImageSpec spec(barrel.pinhole.height, barrel.pinhole.width, 3, OIIO::TypeUInt8);
  spec.attribute("Orientation", 6);
  OIIO::ImageBuf turned(spec);
  REQUIRE(turned.write((in / "turned.jpg").string()));
  const ProgramRun run =
      run_cps("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string());
  INFO(run.output);
  CHECK(run.exit_status == 0);
  CHECK_THAT(run.output, Catch::Contains("1 pictures were turned upright"));
  CHECK(read_image(out / "turned.jpg").spec().width == barrel.pinhole.width);

  OIIO::ImageSpec flat(barrel.pinhole.width, barrel.pinhole.height, 3, OIIO::TypeUInt8);
  flat.attribute("Orientation", 6);
  OIIO::ImageBuf portrait(flat);
  REQUIRE(portrait.write((in / "turned.jpg").string()));
  check_refused("undistort " + (in / "turned.jpg").string() + " -o " + (folder.path / "b.jpg").string() +
                    " --lens " + lens.string(),
                1, "is 100 x 160 pixels upright, as its EXIF orientation says");
}
