#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "numbers/angles.h"
#include "trainer/evaluation/evaluation_bins.h"

using namespace cps;

namespace {

/// An image of a camera with this k1 in apparent space. The training mean is always off three times as far.
EvaluatedImage judged_image(double hfov_deg, double k1, int cluster, double error_deg) {
  EvaluatedImage image;
  image.image.truth =
      *to_camera({radians(hfov_deg), k1, 0, 0, 0, 0, .5, .5}, TargetSpace::apparent, 480, 270);
  image.image.camera = "front";
  image.image.cluster = cluster;
  image.network.hfov_deg = error_deg;
  image.network.reprojection_px = 10 * error_deg;
  image.training_mean.hfov_deg = 3 * error_deg;
  image.training_mean.reprojection_px = 30 * error_deg;
  return image;
}

std::vector<EvaluationBin> bins_of_kind(const std::vector<EvaluatedImage>& images, const std::string& kind) {
  std::vector<EvaluationBin> bins;
  for (const EvaluationBin& bin : bins_of(images, 200, 0))
    if (bin.kind == kind) bins.push_back(bin);
  return bins;
}

}  // namespace

TEST_CASE("bins by lens strength hold the images whose k1 lies in them and are in its order") {
  const std::vector<EvaluatedImage> images{judged_image(65, .02, 0, 1), judged_image(64, -.05, 1, 2),
                                           judged_image(8, -.21, 2, 4), judged_image(66, -.25, 3, 6)};
  const std::vector<EvaluationBin> lens = bins_of_kind(images, "lens");
  REQUIRE(lens.size() == 3);
  const char* names[] = {"K1 -0.3 to -0.2", "K1 -0.1 to 0.0", "K1 0.0 to 0.1"};
  const int counts[] = {2, 1, 1};
  const double means_deg[] = {5, 2, 1}, lows[] = {-.3, -.1, 0};
  for (int i = 0; i < 3; ++i) {
    CHECK(lens[i].name == names[i]);
    CHECK(lens[i].images == counts[i]);
    CHECK(lens[i].network.hfov_mean_deg == Approx(means_deg[i]));
    CHECK(lens[i].training_mean.reprojection_mean_px == Approx(30 * means_deg[i]));
    REQUIRE(lens[i].range);
    CHECK(lens[i].range->low == Approx(lows[i]).margin(1e-12));
    CHECK(lens[i].range->high == Approx(lows[i] + .1).margin(1e-12));
  }

  const std::vector<EvaluationBin> hfov = bins_of_kind(images, "H-FOV");
  REQUIRE(hfov.size() == 2);
  CHECK(hfov[0].name == "  0 to  10 deg");
  CHECK(hfov[0].range == Interval{0, 10});
  CHECK(hfov[1].name == " 60 to  70 deg");
  CHECK(hfov[1].images == 3);
  for (const char* kind : {"size", "camera"}) {
    const std::vector<EvaluationBin> all = bins_of_kind(images, kind);
    REQUIRE(all.size() == 1);
    CHECK(all[0].images == 4);
    CHECK_FALSE(all[0].range);
  }
  CHECK(bins_of_kind(images, "size")[0].name == "480x270");
}

TEST_CASE("intervals of a bin are those of drawing its places") {
  // Two places, two images each, with mean errors of 1 and 3: draws give 1, 2 and 3 with shares 1/4, 1/2,
  // 1/4. A third place is in another bin.
  std::vector<EvaluatedImage> images{judged_image(65, -.12, 7, .5), judged_image(65, -.13, 7, 1.5),
                                     judged_image(65, -.14, 9, 2), judged_image(65, -.15, 9, 4),
                                     judged_image(65, .35, 8, 100)};
  const EvaluationBin bin = bins_of_kind(images, "lens").at(0);
  CHECK(bin.network.hfov_mean_deg == Approx(2));
  CHECK(bin.hfov_interval_deg.low == Approx(1));
  CHECK(bin.hfov_interval_deg.high == Approx(3));
  CHECK(bin.reprojection_interval_px.low == Approx(10));
  CHECK(bin.reprojection_interval_px.high == Approx(30));
  CHECK(std::isinf(bins_of_kind(images, "lens").at(1).hfov_interval_deg.high));  // one place says nothing

  images[0].network.reprojection_px.reset();  // not a camera: left out, as from the mean
  const EvaluationBin without = bins_of_kind(images, "lens").at(0);
  CHECK(without.network.reprojection_mean_px == Approx(25));
  CHECK(without.reprojection_interval_px.low == Approx(15));
}

TEST_CASE("images are ordered by reprojection error with those that have none at the end") {
  std::vector<EvaluatedImage> images{judged_image(65, 0, 0, 3), judged_image(65, 0, 1, 9),
                                     judged_image(65, 0, 2, 1)};
  CHECK(by_reprojection_error(images) == std::vector{2, 0, 1});
  images[2].network.reprojection_px.reset();
  CHECK(by_reprojection_error(images) == std::vector{0, 1, 2});
}
