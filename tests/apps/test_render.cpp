#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "dataset/exchange/model_calibration.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "tests/apps/cps_program.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

struct Exr {
  OIIO::ImageSpec spec;
  std::vector<char> pixels;  ///< each channel in its own type

  const char* channel(int x, int y, const std::string& name) const {
    const int index = spec.channelindex(name);
    REQUIRE(index >= 0);
    std::size_t offset = 0;
    for (int c = 0; c < index; ++c) offset += spec.channelformat(c).size();
    return &pixels[(std::size_t(y) * spec.width + x) * spec.pixel_bytes(true) + offset];
  }
  float real(int x, int y, const std::string& name) const {
    float value;
    std::memcpy(&value, channel(x, y, name), sizeof value);
    return value;
  }
  std::uint32_t id(int x, int y, const std::string& name) const {
    REQUIRE(spec.channelformat(spec.channelindex(name)) == OIIO::TypeDesc::UINT32);
    std::uint32_t value;
    std::memcpy(&value, channel(x, y, name), sizeof value);
    return value;
  }
};

Exr read_exr(const fs::path& file) {
  const auto in = OIIO::ImageInput::open(file.string());
  REQUIRE(in);
  Exr exr{in->spec(), std::vector<char>(in->spec().image_bytes(true))};
  REQUIRE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UNKNOWN, exr.pixels.data()));
  return exr;
}

const std::string view = " --position=-150,1.65,-60 --look-at=0,1.65,-60 --size 64x36 ";

}  // namespace

TEST_CASE("render writes all layers through the lens into one EXR, ids as exact integers") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  for (const std::string how : {"", " --lens-in-camera"}) {
    const fs::path out = folder / "a.exr";
    const ProgramRun run = run_cps("render " + scene.string() + view + " --hfov 80 --lens k1=-0.05,p1=0.002" +
                                   how + " --aov all -o " + out.string());
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    const Exr exr = read_exr(out);
    CHECK(exr.spec.width == 64);
    CHECK(exr.spec.height == 36);
    // The lowest row in the middle sees the road, 1.65 m below the camera.
    CHECK(exr.real(32, 35, "position.Y") == Approx(0).margin(1e-4));
    CHECK(exr.real(32, 35, "normal.Y") == Approx(1).margin(1e-3));
    CHECK(exr.real(32, 35, "albedo.R") == Approx(0.3).margin(0.01));
    CHECK(exr.id(32, 35, "instance.id") == 1);
    CHECK(exr.id(32, 35, "material.id") == 1);
    CHECK(exr.real(32, 35, "distance.Y") > exr.real(32, 35, "depth.Z"));
    CHECK(exr.real(32, 35, "R") > 0);
    CHECK((exr.spec.channelindex("variance.R") >= 0) == !how.empty());
    CHECK(std::isinf(exr.real(32, 0, "depth.Z")));
    CHECK(exr.id(32, 0, "instance.id") == 0);
  }
}

TEST_CASE("render shows more than a half space through a fisheye, with a mask of what it sees") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  const std::string run = "render " + scene.string() +
                          " --position=-150,1.65,-60 --look-at=0,1.65,-60 --size "
                          "64x64 --samples 4 --lens ";
  const fs::path out = folder / "a.exr", valid = folder / "valid.png";
  // Equidistant, 250° along the row: the circle of what exists has a radius of 32 · 180/125 = 46.08 pixels,
  // the corners lie 45.25 pixels off. At 270° it has 42.67.
  for (const int hfov_deg : {250, 270}) {
    const ProgramRun made =
        run_cps(run + "kannala_brandt --hfov " + std::to_string(hfov_deg) +
                " --aov depth,distance,normal -o " + out.string() + " --valid " + valid.string());
    INFO(made.output);
    REQUIRE(made.exit_status == 0);
    CHECK_THAT(made.output, Catch::Contains("H-FOV " + std::to_string(hfov_deg) + " deg"));
    CHECK((made.output.find("left black") != std::string::npos) == (hfov_deg == 270));
    const Exr exr = read_exr(out);
    const double f = 32 / (hfov_deg / 360.0 * 3.14159265358979);
    // Straight down the middle column: the road, 1.65 m below, at the angle r/f from the axis.
    const double angle = 25.5 / f;
    CHECK(angle > 1.5707963);
    CHECK(exr.real(32, 57, "normal.Y") == Approx(1).margin(1e-3));
    CHECK(exr.real(32, 57, "distance.Y") * std::sin(angle) == Approx(1.65).epsilon(2e-3));
    CHECK(exr.real(32, 57, "depth.Z") < 0);  // behind the camera
    const auto mask = OIIO::ImageInput::open(valid.string());
    REQUIRE(mask);
    std::vector<unsigned char> seen(64 * 64);
    REQUIRE(mask->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT8, seen.data()));
    CHECK(seen[0] == (hfov_deg == 250 ? 255 : 0));
    CHECK(seen[32 * 64 + 2] == 255);
    if (hfov_deg == 270) CHECK(exr.real(0, 0, "R") == 0);
  }
}

TEST_CASE("render traces a calibrated fisheye as its parameters") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  const ModelCamera camera = *camera_from_seen_hfov(DoubleSphere{-0.2, 0.55}, 64, 36, radians(150));
  write_model_calibration(folder / "ds.json", CalibrationFormat::cps, std::vector{camera});
  const std::string run = "render " + scene.string() + view + "--samples 2 --aov position -o ";
  const ProgramRun file =
      run_cps(run + (folder / "a.exr").string() + " --lens " + (folder / "ds.json").string());
  INFO(file.output);
  REQUIRE(file.exit_status == 0);
  REQUIRE(run_cps(run + (folder / "b.exr").string() +
                  " --lens double_sphere:xi=-0.2,alpha=0.55 --hfov 150 --lens-in-camera")
              .exit_status == 0);
  const Exr a = read_exr(folder / "a.exr"), b = read_exr(folder / "b.exr");
  CHECK(a.pixels == b.pixels);
}

TEST_CASE("render replays one sample and logs the error against a reference") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path, scene = write_street_gltf(folder);
  const ProgramRun replay = run_cps("render " + scene.string() + view + "--replay 32,30,2");
  INFO(replay.output);
  REQUIRE(replay.exit_status == 0);
  for (const char* part :
       {"pixel 32, 30, sample 2", "vertex 0:", "material 0", "throughput", "end: ", "radiance "})
    CHECK_THAT(replay.output, Catch::Contains(part));
  check_refused("render " + scene.string() + view + "--replay 64,3,0", 2, "--replay");

  const std::string reference = (folder / "reference.exr").string();
  REQUIRE(run_cps("render " + scene.string() + view + "--seed 9 --samples 32 -o " + reference).exit_status ==
          0);
  const ProgramRun curve =
      run_cps("render " + scene.string() + view + "--samples 7 --reference " + reference);
  REQUIRE(curve.exit_status == 0);
  CHECK_THAT(curve.output, Catch::StartsWith("samples,cpu_s,rmse,rel_mse,bias\n1,") &&
                               Catch::Contains("\n4,") && Catch::Contains("\n7,"));
}

TEST_CASE("render refuses lenses, cameras and layers that make no sense, in one line") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path;
  const std::string scene = write_street_gltf(folder).string(), out = " -o " + (folder / "a.exr").string();
  check_refused("render " + scene + out + " --lens k1=-0.6 --lens-in-camera", 1, "k1");
  check_refused("render " + scene + out + " --lens k9=1", 2, "k9=1");
  check_refused("render " + scene + out + " --lens kannala_brandt:k9=1", 2, "k9");
  check_refused("render " + scene + out + " --lens eucm:alpha=2", 2, "alpha");
  check_refused("render " + scene + out + " --lens rational:k1=0.1 --hfov 185", 1, "185 degrees");
  check_refused("render " + scene + out + " --hfov 185", 2, "--hfov: must lie between 0 and 180");
  check_refused("render " + scene + out + " --valid x.png", 2, "--valid: needs --lens");
  check_refused("render " + scene + out + " --lens /nonexistent.yaml", 1, "/nonexistent.yaml");
  check_refused("render " + scene + out + " --lens-in-camera", 2, "--lens");
  check_refused("render " + scene + out + " --camera front", 1, "no perspective cameras");
  check_refused("render " + scene + out + " --aov depth,colour", 2, "colour");
  check_refused("render " + scene + out + " --filter wide", 2, "--filter wide");
  check_refused("render " + scene + " --aov all -o " + (folder / "a.png").string(), 2, "--aov");
  check_refused("render " + scene, 2, "--out: is missing");
  check_refused("render " + scene + out + " --sun-irradiance bright", 2, "--sun-irradiance bright");
  check_refused("render " + scene + out + " --sky /nonexistent.hdr", 1, "/nonexistent.hdr");
  check_refused("render " + scene + out + " --memory 1e-5", 1, "is longer than");
  CHECK_FALSE(fs::exists(folder / "a.exr"));
}
