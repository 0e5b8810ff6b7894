#include <catch2/catch.hpp>

#include "dataset/exchange/model_calibration.h"
#include "distortion/models/conversion/convert.h"
#include "tests/apps/cps_program.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// calib_cam_to_cam.txt of 2011-09-26 (Geiger et al. 2013): S, K and D of camera 00.
const ModelCamera kitti_00{"00",
                           {1392, 512, 984.2439, 980.8141, 690.0, 233.1966},
                           Distortion{-0.3728755, 0.2037299, -0.07233722, 0.002219027, 0.001383707}};

const Pinhole wide{960, 400, 300, 300, 479.5, 199.5};

fs::path write_calibration(const fs::path& folder, const std::string& name, const ModelCamera& camera) {
  const fs::path file = folder / (name + ".json");
  write_model_calibration(file, CalibrationFormat::cps, std::vector{camera});
  return file;
}

}  // namespace

TEST_CASE("lens check reports on lenses of every family") {
  const TemporaryFolder folder;
  const Pinhole narrow{640, 480, 900, 900, 319.5, 239.5};
  const std::vector<std::pair<LensModel, Pinhole>> cameras{{RationalLens{.k1 = 0.2, .k4 = 0.4}, narrow},
                                                           {KannalaBrandt{.k1 = -0.02}, wide},
                                                           {UnifiedSpherical{.xi = 0.8}, narrow},
                                                           {Eucm{.alpha = 0.6, .beta = 1.1}, wide},
                                                           {DoubleSphere{.xi = -0.2, .alpha = 0.6}, wide}};
  for (const auto& [lens, pinhole] : cameras) {
    const fs::path file =
        write_calibration(folder.path, std::string(family_name(lens)), {"cam", pinhole, lens});
    const ProgramRun run = run_cps("lens check " + file.string());
    INFO(run.output);
    CHECK(run.exit_status == 0);
    CHECK_THAT(run.output, Catch::Contains(description(lens)) && Catch::Contains("yes, proved") &&
                               Catch::Contains("seen") && Catch::Contains("proved up to") &&
                               Catch::Contains("worst residual"));
  }
}

TEST_CASE("lens check counts angles beyond 180 degrees in full, and a sphere's focal length on its axis") {
  const TemporaryFolder folder;
  // Equidistant: 960 px at 300 px per radian are 3.2 radians.
  const fs::path equidistant = write_calibration(folder.path, "equidistant", {"cam", wide, KannalaBrandt{}});
  CHECK_THAT(run_cps("lens check " + equidistant.string()).output,
             Catch::Contains("seen 183.35 horizontally"));
  const fs::path sphere = write_calibration(
      folder.path, "sphere", {"cam", {640, 480, 900, 900, 319.5, 239.5}, UnifiedSpherical{.xi = 0.8}});
  CHECK_THAT(run_cps("lens check " + sphere.string()).output,
             Catch::Contains("label 65.24 x 51.28 degrees, of the focal lengths 500 and 500"));
}

TEST_CASE("lens check refuses a fisheye whose polynomial turns back inside the frame") {
  const TemporaryFolder folder;
  // θ − .3 θ³ grows up to 60.4°, to a radius of .70; the frame's corners are at 1.73.
  const fs::path file = write_calibration(folder.path, "folds", {"cam", wide, KannalaBrandt{.k1 = -0.3}});
  const ProgramRun run = run_cps("lens check " + file.string());
  INFO(run.output);
  CHECK(run.exit_status == 1);
  CHECK_THAT(run.output, Catch::Contains("no: proved for") &&
                             Catch::Contains("cps: " + file.string() + ": camera cam: "));
}

TEST_CASE("lens convert writes the camera that it reports on") {
  const TemporaryFolder folder;
  const fs::path file = write_calibration(folder.path, "kitti", kitti_00), output = folder.path / "eucm.json";
  const ProgramRun run = run_cps("lens convert " + file.string() + " --to eucm -o " + output.string());
  INFO(run.output);
  REQUIRE(run.exit_status == 0);
  const ModelCamera written = read_model_camera(output, "");
  const ConvertedCamera expected = convert(kitti_00, "eucm");
  CHECK(written.pinhole == expected.camera.pinhole);
  CHECK(written.lens == expected.camera.lens);
  CHECK_THAT(run.output, Catch::Contains(description(written.lens)) &&
                             Catch::Contains(fmt::format("rms {:.3g} px, worst {:.3g} px", expected.rms_px,
                                                         expected.worst_px)) &&
                             Catch::Contains(fmt::format("{:.2f} % of the rays", 100 * expected.covered)));
  CHECK(run_cps("lens check " + output.string()).exit_status == 0);

  const fs::path rational = folder.path / "rational.yml";
  REQUIRE(run_cps("lens convert " + file.string() +
                  " --to rational --format opencv-yaml --max-residual 1e-6" + " -o " + rational.string())
              .exit_status == 0);
  const ModelCamera exact = read_model_camera(rational, "");
  CHECK(exact.pinhole == kitti_00.pinhole);
  CHECK(parameters(exact.lens).front().second == -0.3728755);

  const fs::path held = folder.path / "held.json";
  REQUIRE(run_cps("lens convert " + file.string() +
                  " --to unified_spherical --hold xi=1.2,k1=0,k2=0,k3=0,p1=0,p2=0 -o " + held.string())
              .exit_status == 0);
  CHECK(read_model_camera(held, "").lens == LensModel(UnifiedSpherical{.xi = 1.2}));
}

TEST_CASE("lens convert refuses in one line, and writes nothing") {
  const TemporaryFolder folder;
  const fs::path file = write_calibration(folder.path, "kitti", kitti_00), output = folder.path / "out";
  const fs::path fisheye = write_calibration(folder.path, "fisheye", {"cam", wide, KannalaBrandt{}});
  const auto refused = [&](const fs::path& from, const std::string& options, int status,
                           const std::string& expected) {
    check_refused("lens convert " + from.string() + " -o " + output.string() + " " + options, status,
                  expected);
    CHECK_FALSE(fs::exists(output));
  };
  refused(file, "--to fisheye", 2, "'fisheye' is none of brown_conrady, rational");
  refused(file, "", 2, "to");
  refused(file, "--to eucm --format pdf", 2, "'pdf' is none of cps");
  refused(file, "--to eucm --hold gamma=1", 2, "--hold: eucm: unknown parameter 'gamma'");
  refused(file, "--to eucm --hold alpha=2", 2, "alpha");
  refused(file, "--to eucm --hold alpha", 2, "'alpha' must be a name, = and a number");
  refused(file, "--to eucm --max-residual -1", 2, "--max-residual");
  refused(file, "--to eucm --max-residual 0.01", 1, "more than --max-residual 0.01");
  refused(file, "--to double_sphere --format kitti", 1, "kalibr");
  refused(file, "--to eucm --camera 07", 1, "'07'");
  refused(fisheye, "--to brown_conrady", 1, "camera cam: sees");
  check_refused("lens convert " + file.string() + " --to eucm -o " + file.string(), 1, "would replace");
  CHECK(read_model_camera(file, "").lens == kitti_00.lens);
}
