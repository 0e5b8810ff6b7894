#include "dataset/exchange/model_calibration.h"
#include "dataset/labels/reader.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// A fisheye of 160 × 100 pixels.
ModelCamera fisheye(double hfov_deg) {
  ModelCamera camera = *camera_from_seen_hfov(KannalaBrandt{-.03, .004, 0, 0}, 160, 100, radians(hfov_deg));
  camera.name = "fish";
  camera.pinhole.cx += 1.5;
  camera.pinhole.cy -= 2;
  return camera;
}

fs::path write_fisheye(const fs::path& folder, double hfov_deg) {
  const fs::path file = folder / "fisheye.yaml";
  write_model_calibration(file, CalibrationFormat::kalibr, std::vector{fisheye(hfov_deg)});
  return file;
}

int black_pixels(const OIIO::ImageBuf& image) {
  int black = 0;
  for (int y = 0; y < image.spec().height; ++y)
    for (int x = 0; x < image.spec().width; ++x) black += image.getchannel(x, y, 0, 0) == 0;
  return black;
}

}  // namespace

TEST_CASE("through a fisheye and back, a picture returns within the kernels' blur") {
  const TemporaryFolder folder;
  const fs::path lens = write_fisheye(folder.path, 90), ideal = folder.path / "ideal.png",
                 seen = folder.path / "seen.png", back = folder.path / "back.png";
  const auto wave = [](int x, int y) { return 0.5 + 0.2 * std::sin(x / 5.0) + 0.2 * std::cos(y / 4.0); };
  write_image(ideal, 320, 200, 3, OIIO::TypeUInt16, [&](int x, int y, int) { return wave(x, y); });
  run_well("distort " + ideal.string() + " -o " + seen.string() + " --hfov 105 --lens " + lens.string() +
           " --encoding linear --label-format ros --label " + (folder.path / "ros.yaml").string());
  const ModelCamera taken = read_model_camera(folder.path / "ros.yaml", "");
  CHECK(taken.lens == fisheye(90).lens);
  CHECK(taken.pinhole == fisheye(90).pinhole);  // 105° show enough
  run_well("undistort " + seen.string() + " -o " + back.string() + " --lens " +
           (folder.path / "ros.yaml").string() + " --hfov 105 --size 320x200 --encoding linear --sigma 0.5");
  const OIIO::ImageBuf image = read_image(back);
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
  // As for Brown-Conrady lenses (test_resampling.cpp); the fisheye's rim is coarser by up to 1/cos² 50°.
  CHECK(worst < 0.08);
}

TEST_CASE("each pixel of a distorted picture shows the ideal point that the fisheye's label says") {
  const TemporaryFolder folder;
  const fs::path lens = write_fisheye(folder.path, 120), in = folder.path / "a.exr",
                 out = folder.path / "b.exr";
  write_image(in, 320, 200, 3, OIIO::TypeFloat, [](int x, int y, int c) {
    return c == 0 ? x : c == 1 ? y : 1;
  });
  run_well("distort " + in.string() + " -o " + out.string() + " --hfov 100 --lens " + lens.string());
  const ModelCamera taken = read_model_camera(folder.path / "b_calibration.json", "");
  CHECK(taken.pinhole.fx > fisheye(120).pinhole.fx);  // zoomed until no border was left
  const Pinhole source = pinhole_from_hfov(320, 200, radians(100));
  const RayRegion region = certify_frame(taken, one_to_one).region;
  const OIIO::ImageBuf image = read_image(out);
  double worst_px = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      REQUIRE(image.getchannel(x, y, 0, 2) == Approx(1).margin(1e-5));
      const Eigen::Vector3d ray =
          unproject(taken.lens, region, to_plane(taken.pinhole, Eigen::Vector2d(x, y))).value();
      const Eigen::Vector2d expected = to_pixel(source, ray.head<2>() / ray.z());
      worst_px = std::max(
          worst_px,
          (Eigen::Vector2d(image.getchannel(x, y, 0, 0), image.getchannel(x, y, 0, 1)) - expected).norm());
    }
  CHECK(worst_px < 0.1);  // the kernel's ripple
}

TEST_CASE("undistort straightens the middle of a fisheye, and masks what it lacks") {
  const TemporaryFolder folder;
  const fs::path lens = write_fisheye(folder.path, 190), in = folder.path / "a.png",
                 out = folder.path / "b.png", valid = folder.path / "valid.png";
  write_image(in, 160, 100, 1, OIIO::TypeUInt8, [](int, int, int) { return 1; });
  const std::string run = "undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string() +
                          " --valid " + valid.string();
  run_well(run);
  CHECK(label(folder.path / "b_calibration.json").distortion == Distortion{});
  CHECK(degrees(hfov_rad(label(folder.path / "b_calibration.json").pinhole)) <= 160 + 1e-6);
  CHECK(black_pixels(read_image(out)) == 0);
  CHECK(black_pixels(read_image(valid)) == 0);
  run_well(run + " --hfov 165");
  const OIIO::ImageBuf image = read_image(out), mask = read_image(valid);
  int black = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x) {
      black += image.getchannel(x, y, 0, 0) == 0;
      CHECK((image.getchannel(x, y, 0, 0) > 0) == (mask.getchannel(x, y, 0, 0) > 0));
    }
  CHECK(black > 0);
  CHECK(black < 16000);
  check_refused(run + " --keep all", 1, "fisheye.yaml");
}

TEST_CASE("the mask of undistort serves Brown-Conrady lenses too") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), in = folder.path / "a.png", out = folder.path / "b.png",
                 valid = folder.path / "valid.png";
  write_image(in, 160, 100, 1, OIIO::TypeUInt8, [](int, int, int) { return 1; });
  run_well("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string() +
           " --keep all --valid " + valid.string());
  const OIIO::ImageBuf image = read_image(out), mask = read_image(valid);
  for (int y = 0; y < image.spec().height; ++y)
    for (int x = 0; x < image.spec().width; ++x)
      CHECK((image.getchannel(x, y, 0, 0) > 0) == (mask.getchannel(x, y, 0, 0) > 0));
  CHECK(black_pixels(mask) > 0);
  check_refused("undistort " + in.string() + " -o " + out.string() + " --lens " + lens.string() +
                    " --valid " + in.string(),
                1, "would be replaced");
}

TEST_CASE("a fisheye's pictures go to another lens at once") {
  const TemporaryFolder folder;
  const fs::path lens = write_barrel(folder.path), source = write_fisheye(folder.path, 170),
                 in = folder.path / "a.exr", out = folder.path / "b.exr";
  write_image(in, 160, 100, 3, OIIO::TypeFloat, [](int x, int y, int c) {
    return c == 0 ? x : c == 1 ? y : 1;
  });
  run_well("distort " + in.string() + " -o " + out.string() + " --source " + source.string() + " --lens " +
           lens.string() + " --size 80x50");
  const CalibratedCamera taken = label(folder.path / "b_calibration.json");
  const FrameCertificate frame = certify_frame(taken.distortion, taken.pinhole, one_to_one);
  const OIIO::ImageBuf image = read_image(out);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(40, 24), std::pair(79, 49), std::pair(70, 3)}) {
    const Eigen::Vector2d ideal =
        undistort(taken.distortion, frame.rectangle, to_plane(taken.pinhole, Eigen::Vector2d(x, y))).value();
    const ModelCamera fish = fisheye(170);
    const Eigen::Vector2d expected =
        to_pixel(fish.pinhole, project(fish.lens, {ideal.x(), ideal.y(), 1}).point);
    CHECK(image.getchannel(x, y, 0, 0) == Approx(expected.x()).margin(0.1));
    CHECK(image.getchannel(x, y, 0, 1) == Approx(expected.y()).margin(0.1));
  }
  check_refused("distort " + in.string() + " -o " + out.string() + " --source " + source.string() +
                    " --lens_draw shape_prior",
                1, "kannala_brandt");
}

TEST_CASE("a label format without a place for the lens is refused before any picture is made") {
  const TemporaryFolder folder;
  const fs::path lens = write_fisheye(folder.path, 90), in = folder.path / "a.png",
                 out = folder.path / "b.png";
  write_image(in, 320, 200, 1, OIIO::TypeUInt8, noise);
  check_refused("distort " + in.string() + " -o " + out.string() + " --hfov 105 --lens " + lens.string() +
                    " --label-format kitti",
                1, "kannala_brandt");
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("relens straightens a fisheye's pictures first") {
  const TemporaryFolder folder;
  const fs::path lens = write_fisheye(folder.path, 150), out = folder.path / "set";
  const ModelCamera camera = fisheye(150);
  const RayRegion region = certify_frame(camera, one_to_one).region;
  const auto value_of = [](double ideal_x) { return .5 + .2 * ideal_x; };
  write_image(folder.path / "photos/0.png", 160, 100, 1, OIIO::TypeUInt16, [&](int x, int y, int) {
    const Eigen::Vector3d ray =
        unproject(camera.lens, region, to_plane(camera.pinhole, Eigen::Vector2d(x, y))).value();
    return std::clamp(value_of(ray.x() / ray.z()), 0.02, 0.98);
  });
  const std::string run = "relens --pictures " + (folder.path / "photos").string() + " --lens " +
                          lens.string() + " -o " + out.string();
  check_refused(run + " --straight-hfov 150", 1, "--straight-hfov 150");
  run_well(run + " --lenses 3 --seed 2 --straight-hfov 95 --size 60x36");
  const Dataset set = read_dataset(out);
  REQUIRE(set.images.size() == 3);
  for (const DatasetImage& image : set.images) {
    const Label& label = set.groups[image.group].label;
    CHECK(set.groups[image.group].folder.string().find("_hfov095/") != std::string::npos);
    const FrameCertificate frame = certify_frame(label.distortion, label.camera, one_to_one);
    const OIIO::ImageBuf pixels = read_image(out / image.file);
    double worst_px = 0;
    for (int y = 0; y < 36; ++y)
      for (int x = 0; x < 60; ++x) {
        const Eigen::Vector2d ideal =
            undistort(label.distortion, frame.rectangle, to_plane(label.camera, Eigen::Vector2d(x, y)))
                .value();
        // One output pixel is a step of .2/fx.
        worst_px = std::max(
            worst_px, std::abs(pixels.getchannel(x, y, 0, 0) - value_of(ideal.x())) / .2 * label.camera.fx);
      }
    CHECK(worst_px < .25);
  }
}
