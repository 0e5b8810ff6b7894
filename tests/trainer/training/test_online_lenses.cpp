#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/certificate/certificate.h"
#include "distortion/label_algebra.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "tests/trainer/street_masters.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/training/online_images.h"
#include "trainer/training/online_lens.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

/// A master of a 60° set, made for lenses that reach as far as 80°.
KeptMaster wide_master() {
  KeptMaster master;
  master.file = "a master";
  master.set = pinhole_from_hfov(174, 64, radians(60));
  master.base = pinhole_from_hfov(174, 64, radians(80));
  master.camera = master_camera(master.base, {.oversampling = 2.6}, .15);
  return master;
}

OnlineLensOptions shape_prior(double undistorted_share = 0) {
  OnlineLensOptions options;
  options.lens.scheme = LensScheme::shape_prior;
  options.undistorted_share = undistorted_share;
  return options;
}

CalibratedCamera calibration_of(const TrainOptions& options, const ShownImage& image) {
  return to_camera(image.target, options.target_space, image.original.width, image.original.height).value();
}

/// Correlation of two pictures' pixels, which knows no brightness or contrast.
double correlation(const GrayImage& a, const GrayImage& b) {
  double n = a.pixels.size(), sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double x = a.pixels[i], y = b.pixels[i];
    sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
  }
  return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

struct StreetMasters {
  TemporaryFolder folder;
  Dataset dataset;
  explicit StreetMasters(int count, const ImageSize& size = {174, 64}) {
    dataset = make_street_dataset(folder.path / "data", {.sizes = {size},
                                                         .fields_of_view = 2,
                                                         .lenses_per_part = 1,
                                                         .train_places = 1,
                                                         .val_places = 1,
                                                         .test_places = 1});
    keep_street_masters(folder.path / "data", size, count);
  }
  TrainingSet images(const TrainOptions& options) const {
    return online_images(dataset, options, folder.path / "masters.cache");
  }
};

TrainOptions at_full_size(bool mirror) {
  TrainOptions options;
  options.online_lenses = true;
  options.reduction.width = 4096;
  options.mirror = mirror;
  return options;
}

}  // namespace

TEST_CASE("every online lens is certified, stays inside its master and within what it carries") {
  const KeptMaster master = wide_master();
  const double widest = std::tan(hfov_rad(master.base) / 2);
  int undistorted = 0;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    const DrawnLens lens = draw_online_lens(master, shape_prior(.25), Stream{static_cast<std::uint64_t>(i)});
    REQUIRE(certify(lens.distortion, frame_on_plane(lens.base)).valid);
    const CalibratedCamera drawn{"", lens.crop.camera, lens.distortion};
    const auto rays = loss_rays(drawn, frame_on_plane(lens.base), "lens");
    REQUIRE(reprojection_error_px(*rays, drawn) < 1e-6);
    REQUIRE(std::tan(hfov_rad(lens.base) / 2) <= widest * (1 + 1e-12));
    const double ratio = lens.crop.camera.fx / master.set.fx;
    REQUIRE(ratio <= 1.3 * (1 + 1e-6));
    REQUIRE(ratio >= 1 / 1.3 * (1 - 1e-6));
    // What warp() asks of magnification: it throws where the master does not carry the lens.
    if (i % 50 == 0) {
      const OIIO::ImageBuf blank(
          OIIO::ImageSpec(master.camera.width, master.camera.height, 1, OIIO::TypeDesc::FLOAT));
      REQUIRE_NOTHROW(
          warp(blank, master.camera, lens.distortion, lens.crop.camera, {.box = frame_on_plane(lens.base)}));
    }
    undistorted += lens.distortion.k1 == 0;
  }
  // A binomial of p = 1/4: five standard deviations.
  CHECK(std::abs(undistorted - draws / 4.) < 5 * std::sqrt(draws * .25 * .75));
}

TEST_CASE("a lens has its rays though rectangles of the frame's own shape cannot be certified") {
  // One of the few in ten thousand draws: its frame is far off centre, its base's is not.
  const CalibratedCamera drawn{
      "",
      {174, 64, 243.42598869940539, 243.42598869940539, 84.841731710740362, 32.524730258408923},
      {0.94400134198808239, -1.0861710759700309, -36.626495356620701, -0.029191726856715377,
       0.0018617919480476955}};
  const Eigen::AlignedBox2d base = frame_on_plane(pinhole_from_hfov(174, 64, radians(41.390243426044194)));
  REQUIRE(certify(drawn.distortion, base).valid);
  REQUIRE_FALSE(is_one_to_one(drawn));
  for (const CalibratedCamera& lens : {drawn, mirrored_left_right(drawn)}) {
    const auto rays = loss_rays(lens, base, "lens");
    CHECK(rays->pixels.size() == 12 * 4);
    CHECK(reprojection_error_px(*rays, lens) < 1e-6);
  }
  const CalibratedCamera folding{"", drawn.pinhole, {-5, 0, 0, 0, 0}};
  CHECK_THROWS_WITH(loss_rays(folding, base, "lens"), Catch::StartsWith("lens: the lens is not one-to-one"));
}

TEST_CASE("a master that nothing fits into is refused by name") {
  KeptMaster master = wide_master();
  master.base = pinhole_from_hfov(174, 64, radians(20));
  CHECK_THROWS_WITH(draw_online_lens(master, shape_prior(), Stream{1}),
                    Catch::Contains("a master: no lens fits"));
}

TEST_CASE("an online image shows what its target says, flipped or not") {
  const StreetMasters streets(6);
  const bool mirror = GENERATE(false, true);
  const TrainOptions options = at_full_size(mirror);
  const TrainingSet set = streets.images(options);
  int flipped = 0;
  for (int i = 0; i < 6; ++i)
    for (int epoch = 1; epoch <= 3; ++epoch) {
      const ShownImage image = set.shown(i, epoch);
      GrayImage shown = image.pixels;
      if (image.is_mirrored)
        for (int y = 0; y < shown.size.height; ++y)
          std::reverse(shown.pixels.begin() + y * shown.size.width,
                       shown.pixels.begin() + (y + 1) * shown.size.width);
      flipped += image.is_mirrored;
      // The street itself through that lens; a flipped one is the flipped picture of the flipped lens.
      CalibratedCamera truth = calibration_of(options, image);
      if (image.is_mirrored) {
        truth.pinhole.cx = truth.pinhole.width - 1 - truth.pinhole.cx;
        truth.distortion.p2 = -truth.distortion.p2;
      }
      const GrayImage direct = render_street(truth, i);
      INFO("master " << i << ", epoch " << epoch);
      const double good = correlation(image.pixels, direct);
      CHECK(good > .95);  // the direct one is not antialiased alike
      // A lens 2 % longer shows it visibly worse: the target is that exact.
      truth.pinhole.fx = truth.pinhole.fy = 1.02 * truth.pinhole.fx;
      CHECK(correlation(image.pixels, render_street(truth, i)) < good);
    }
  CHECK((flipped > 0) == mirror);
}

TEST_CASE("every epoch draws new lenses, and the same ones again when asked again") {
  const StreetMasters streets(3);
  const TrainOptions options = at_full_size(true);
  const TrainingSet set = streets.images(options), again = streets.images(options);
  for (int i = 0; i < 3; ++i) {
    CHECK(set.shown(i, 1).target != set.shown(i, 2).target);
    CHECK(set.shown(i, 1).target == again.shown(i, 1).target);
    CHECK(set.shown(i, 1).pixels.pixels == again.shown(i, 1).pixels.pixels);
  }
  TrainOptions other = options;
  other.seed = 1;
  CHECK(streets.images(other).shown(0, 1).target != set.shown(0, 1).target);
}

TEST_CASE("online statistics are those of the images before the first epoch") {
  const StreetMasters streets(5);
  const TrainingSet set = streets.images(at_full_size(true));
  double fov = 0;
  for (int i = 0; i < 5; ++i) fov += set.shown(i, 0).target[0] / 5;
  CHECK(set.targets.mean[0] == Approx(fov).epsilon(1e-12));
  CHECK(set.pixels.deviation > 10);
}

TEST_CASE("training on online lenses resumes bit for bit, with the reprojection loss, too") {
  const StreetMasters streets(8, {96, 54});
  TrainOptions options;
  options.online_lenses = true;
  options.loss = GENERATE(Loss::mse, Loss::reprojection);
  options.reduction.width = 48;
  options.epochs = 2;
  options.batch_size = 4;
  options.threads = 2;
  const auto path = [&](const char* name) { return streets.folder.path / name; };
  const TrainSummary whole = train(streets.dataset, path("whole"), options, false, {});
  CHECK(whole.training_images == 8);
  train(streets.dataset, path("parts"), options, false, [](const EpochReport&) { return false; });
  CHECK(train(streets.dataset, path("parts"), {}, true, {}).is_finished);
  CHECK(read_file(path("whole") / "weights.pt") == read_file(path("parts") / "weights.pt"));
}

TEST_CASE("a dataset without masters, and a damaged master, are one line each") {
  const StreetMasters streets(3);
  const auto root = streets.folder.path / "data";
  TrainOptions options = at_full_size(false);
  write_file(root / "masters/set/front_1.exr", std::string("not an image"));
  CHECK_THROWS_WITH(streets.images(options), Catch::Contains("front_1.exr: cannot be read as a master"));
  options.skip_bad_images = true;
  const TrainingSet set = streets.images(options);
  CHECK(set.originals.size() == 2);
  REQUIRE(set.skipped.size() == 1);
  CHECK_THAT(set.skipped[0], Catch::Contains("front_1.exr"));
  std::filesystem::remove(root / "masters.csv");
  CHECK_THROWS_WITH(streets.images(options), Catch::Contains("keep_masters = true"));
}
