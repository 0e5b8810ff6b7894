#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "dataset/exchange/camera_json.h"
#include "dataset/labels/label.h"
#include "dataset/labels/label_check.h"
#include "dataset/panorama_draw.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/source_resolution.h"
#include "distortion/panorama/panorama_warp.h"
#include "distortion/warp/warp_options.h"
#include "numbers/angles.h"
#include "sampler/lenses/model_prior.h"

using namespace cps;

namespace {

std::vector<std::string> all_families() {
  std::vector<std::string> families{"brown_conrady"};
  for (const std::string_view family : prior_families()) families.emplace_back(family);
  return families;
}

ModelCamera camera_in(const PanoramaView& view) {
  const nlohmann::json json = nlohmann::json::parse(view.label.dump());
  const std::string file = "label";
  return model_camera_from_json({json, file});
}

}  // namespace

TEST_CASE("a panorama's part depends on its name alone, in the shares that are promised") {
  std::map<Part, int> counts;
  constexpr int names = 20000;
  for (int i = 0; i < names; ++i) ++counts[part_of_panorama("place" + std::to_string(i))];
  // Four standard deviations of a binomial.
  const auto within = [](int count, double share) {
    return std::abs(count - share * names) < 4 * std::sqrt(names * share * (1 - share));
  };
  CHECK(within(counts[Part::train], .70));
  CHECK(within(counts[Part::val], .15));
  CHECK(within(counts[Part::test], .15));
  int moved = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string name = "place" + std::to_string(i);
    CHECK(part_of_panorama(name + "_4k") == part_of_panorama(name));
    CHECK(part_of_panorama(name + "_16K") == part_of_panorama(name));
    moved += part_of_panorama(name + "_k") != part_of_panorama(name);
  }
  CHECK(moved > 20);  // another name
}

TEST_CASE("views of panoramas: certified lenses, resolved pixels, labels that agree with the pose") {
  for (const std::string& family : all_families()) {
    const PanoramaSetOptions options{
        .family = family, .hfov_deg = {70, 120}, .views = 6, .size = {96, 64}, .seed = 4};
    REQUIRE(options.fault() == "");
    std::set<std::string> folders;
    for (const PanoramaView& view : draw_panorama_views({"street_4k", 1024}, options)) {
      INFO(family << " " << view.folder);
      folders.insert(view.folder);
      CHECK(view.part == part_of_panorama("street_4k"));
      CHECK(view.label["part"] == to_string(view.part));
      CHECK(family_name(view.camera.lens) == family);
      const ModelCamera labelled = camera_in(view);
      CHECK(labelled.lens == view.camera.lens);
      CHECK(labelled.pinhole == view.camera.pinhole);
      const ModelCertificate proof = certify_frame(view.camera, warpable);
      REQUIRE(proof.valid);
      const double hfov_deg = family == "brown_conrady"
                                  ? degrees(hfov_rad(view.camera.pinhole))
                                  : degrees(seen_fov(view.camera, proof.region)->horizontal_rad);
      CHECK(hfov_deg >= 70 - 1e-6);
      CHECK(hfov_deg <= 120 + 1e-6);
      CHECK(fewest_panorama_px({1024, 512}, view.camera, proof.region) > 1);
      // Down in the panorama is +y.
      const Eigen::Vector3d down =
          panorama_from_camera(view.yaw_rad, view.pitch_rad, view.roll_rad).transpose() *
          Eigen::Vector3d::UnitY();
      for (int i = 0; i < 3; ++i)
        CHECK(view.label["gravity"][i].get<double>() == Approx(down[i]).margin(1e-12));
      CHECK(std::abs(degrees(view.pitch_rad)) <= 15);
      CHECK(std::abs(degrees(view.roll_rad)) <= 10);
      if (family == "brown_conrady") {
        const Label label = label_from_json(nlohmann::json::parse(view.label.dump()), "label");
        CHECK(check_label(label).faults.empty());
      }
    }
    CHECK(folders.size() == 6);
    CHECK(*folders.begin() == "96x64_panoramas/street_4k_lens0001");
  }
}

TEST_CASE("the pose in a label turns rays of the camera to the panorama") {
  const PanoramaSetOptions options{.family = "kannala_brandt", .views = 4, .size = {64, 64}};
  for (const PanoramaView& view : draw_panorama_views({"p", 2048}, options)) {
    // Vehicle: x forward, y left, z up. Panorama: x right, y down, z towards its middle.
    Eigen::Matrix3d panorama_from_vehicle;
    panorama_from_vehicle << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    Eigen::Matrix3d vehicle_from_camera;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        vehicle_from_camera(row, column) = view.label["camera"]["T_vehicle_camera"][row][column];
    CHECK((panorama_from_vehicle * vehicle_from_camera)
              .isApprox(panorama_from_camera(view.yaw_rad, view.pitch_rad, view.roll_rad), 1e-12));
  }
}

TEST_CASE("a view stays the same whatever else is drawn") {
  const PanoramaSetOptions few{.family = "eucm", .views = 2, .size = {64, 48}, .seed = 9};
  PanoramaSetOptions many = few;
  many.views = 5;
  const auto a = draw_panorama_views({"a", 1024}, few), b = draw_panorama_views({"a", 1024}, many),
             other = draw_panorama_views({"b", 1024}, few);
  CHECK(a[1].label.dump() == b[1].label.dump());
  CHECK_FALSE(a[1].camera.lens == other[1].camera.lens);
  many.seed = 10;
  CHECK_FALSE(draw_panorama_views({"a", 1024}, many)[1].camera.lens == a[1].camera.lens);
}

TEST_CASE("what cannot be drawn from panoramas is refused by name") {
  CHECK(PanoramaSetOptions{}.fault() == "");
  CHECK_THAT(PanoramaSetOptions{.family = "rational"}.fault(),
             Catch::StartsWith("lens_model: ") && Catch::Contains("kannala_brandt"));
  CHECK_THAT((PanoramaSetOptions{.hfov_deg = {60, 170}}.fault()), Catch::StartsWith("hfov: "));
  CHECK((PanoramaSetOptions{.family = "eucm", .hfov_deg = {60, 195}}.fault()) == "");
  CHECK_THAT((PanoramaSetOptions{.pitch_deg = {10, -10}}.fault()), Catch::StartsWith("pitch: "));
  CHECK_THAT(PanoramaSetOptions{.views = 0}.fault(), Catch::StartsWith("views: "));
  CHECK_THAT((PanoramaSetOptions{.size = {16, 16}}.fault()), Catch::StartsWith("size: "));
  CHECK_THROWS_WITH(draw_panorama_views({"coarse", 256}, {.family = "eucm", .views = 1, .size = {640, 480}}),
                    Catch::Contains("eucm") && Catch::Contains("640x480") && Catch::Contains("256 pixels"));
}

TEST_CASE("a drawn focal length is uniform where every lens fits and takes the place of the H-FOV") {
  const PanoramaSetOptions options{
      .family = "unified_spherical", .focal_px = {200, 400}, .views = 300, .size = {64, 64}, .seed = 3};
  REQUIRE(options.fault() == "");
  double sum = 0;
  for (const PanoramaView& view : draw_panorama_views({"street", 4096}, options)) {
    const Pinhole& pinhole = view.camera.pinhole;
    const double focal_at_299_px = pinhole.fx * 299 / 64;
    CHECK(pinhole.fx == pinhole.fy);
    CHECK(pinhole.cx == 31.5);
    CHECK((focal_at_299_px >= 200 - 1e-9 && focal_at_299_px <= 400 + 1e-9));
    CHECK(std::get<UnifiedSpherical>(view.camera.lens).distortion == Distortion{});
    CHECK(certify_frame(view.camera, warpable).valid);
    sum += focal_at_299_px;
  }
  // Every ξ up to 1.2 is certified at these focal lengths: a mean of 300, within four standard deviations.
  CHECK(std::abs(sum / 300 - 300) < 4 * 200 / std::sqrt(12.0 * 300));
  CHECK_THAT((PanoramaSetOptions{.family = "eucm", .focal_px = {50, 500}}.fault()),
             Catch::StartsWith("focal: needs"));
  CHECK_THAT((PanoramaSetOptions{.family = "unified_spherical", .focal_px = {500, 50}}.fault()),
             Catch::StartsWith("focal: must lie"));
}
