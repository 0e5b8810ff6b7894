#include "dataset/labels/reader.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// Columns of ideal points, as a gray value.
double value_of(const Eigen::Vector2d& ideal) {
  return .5 + .5 * ideal.x();
}

Eigen::Vector2d ideal_of(const Pinhole& camera, const Distortion& lens, const FrameCertificate& frame, int x,
                         int y) {
  return undistort(lens, frame.rectangle, to_plane(camera, Eigen::Vector2d(x, y))).value();
}

}  // namespace

TEST_CASE("every pixel of a relensed picture shows the ray that its label says") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), out = folder.path / "set";
  const FrameCertificate seen = certify_frame(barrel.distortion, barrel.pinhole, one_to_one);
  for (int i = 0; i < 2; ++i)
    write_image(
        folder.path / "photos" / (std::to_string(i) + ".png"), 160, 100, 1, OIIO::TypeUInt16,
        [&](int x, int y, int) { return value_of(ideal_of(barrel.pinhole, barrel.distortion, seen, x, y)); });
  run_well("relens --pictures " + (folder.path / "photos").string() + " --lens " + lens.string() + " -o " +
           out.string() + " --lenses 4 --seed 2");
  const ProgramRun verified = run_cps("verify " + out.string());
  INFO(verified.output);
  CHECK(verified.exit_status == 0);
  CHECK_THAT(verified.output, Catch::Contains("4 groups, 8 images, 0 faults") &&
                                  Catch::Contains("no dataset.json and frames.csv"));
  const Dataset set = read_dataset(out);
  CHECK(set.groups.size() == 4);
  REQUIRE(set.images.size() == 8);
  for (const DatasetImage& image : set.images) {
    CHECK(image.part == Part::test);
    const Label& label = set.groups[image.group].label;
    const FrameCertificate frame = certify_frame(label.distortion, label.camera, one_to_one);
    const OIIO::ImageBuf pixels = read_image(out / image.file);
    REQUIRE(pixels.spec().width == 80);
    double worst_px = 0;
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 80; ++x) {
        const double expected = value_of(ideal_of(label.camera, label.distortion, frame, x, y));
        // One output pixel is a step of 2/fx. The tolerance allows for two filterings of a ramp in linear
        // light.
        worst_px =
            std::max(worst_px, std::abs(pixels.getchannel(x, y, 0, 0) - expected) * 2 * label.camera.fx);
      }
    CHECK(worst_px < .1);
  }
}

TEST_CASE("what relens cannot use is refused in one line") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path);
  const std::string out = " -o " + (folder.path / "set").string();
  check_refused("relens" + out, 2, "name pictures");
  check_refused("relens --pictures x" + out, 2, "go together");
  check_refused("relens --kitti " + folder.path.string() + out, 1, "calib_cam_to_cam.txt: is missing");
  fs::create_directories(folder.path / "none");
  check_refused("relens --pictures " + (folder.path / "none").string() + " --lens " + lens.string() + out, 1,
                "has no pictures");
  CHECK_FALSE(fs::exists(folder.path / "set"));
  check_refused("relens --kitti x -o " + folder.path.string(), 1, "exists");
}
