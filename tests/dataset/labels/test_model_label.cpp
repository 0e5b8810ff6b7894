#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "dataset/exchange/model_calibration.h"
#include "dataset/labels/label.h"
#include "dataset/labels/model_label.h"
#include "dataset/labels/reader.h"
#include "distortion/models/warp/seen_hfov.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "scenes/rig.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("a fisheye's label is a calibration file of its family with what the image shows") {
  ModelCamera camera = *camera_from_seen_hfov(KannalaBrandt{-.02, .003, 0, 0}, 320, 240, radians(170));
  camera.name = "front";
  ModelLabel label = model_label(camera);
  label.part = Part::val;
  label.seed = 5;
  label.vehicle_from_camera = vehicle_from_camera({.pitch_deg = 10});
  const nlohmann::json json = nlohmann::json::parse(to_json(label).dump());
  CHECK(json["model"] == "kannala_brandt");
  CHECK(json["params"]["k1"] == -.02);
  CHECK_FALSE(json.contains("k1"));
  CHECK_FALSE(json.contains("fov"));
  CHECK(json["fov_true_deg"]["h"].get<double>() == Approx(170).epsilon(1e-9));
  CHECK(json["fov_true_deg"]["v"].get<double>() < 170);
  CHECK(json["certificate"]["min_scale"].get<double>() > 0);
  CHECK(json["certificate"]["max_roundtrip_px"].get<double>() < 1e-9);
  // Pitched up, the camera sees the ground recede: down turns away from its axis.
  CHECK(json["gravity"][0].get<double>() == Approx(0).margin(1e-12));
  CHECK(json["gravity"][1].get<double>() == Approx(std::cos(radians(10))));
  CHECK(json["gravity"][2].get<double>() == Approx(-std::sin(radians(10))));
  CHECK(json["part"] == "val");
  const TemporaryFolder folder;
  write_json(folder.path / "calibration.json", to_json(label));
  CHECK(read_model_camera(folder.path / "calibration.json", "") == camera);
}

TEST_CASE("a reader of Brown-Conrady labels refuses a fisheye's by its family's name") {
  const ModelCamera camera = *camera_from_seen_hfov(Eucm{.6, 1.1}, 320, 240, radians(120));
  const nlohmann::json json = nlohmann::json::parse(to_json(model_label(camera)).dump());
  CHECK_THROWS_WITH(label_from_json(json, "x/calibration.json"),
                    Catch::StartsWith("x/calibration.json: model: is eucm: "));
}

TEST_CASE("a lens that is not one-to-one on the frame has no label") {
  CHECK_THROWS_WITH(model_label({"", pinhole_from_hfov(320, 240, radians(120)), KannalaBrandt{-.3, 0, 0, 0}}),
                    Catch::StartsWith("lens is not certified: "));
}

TEST_CASE("the label of a fisheye that does not reach its frame's corners names a mask and reads back") {
  // Equidistant, 195 degrees along the row of a square: the corners would be at 138 degrees, but the lens
  // ends at 1 + 3 k1 t² = 0, at 115 degrees.
  const double end = radians(115);
  ModelCamera camera =
      *camera_from_seen_hfov(KannalaBrandt{-1 / (3 * end * end), 0, 0, 0}, 96, 96, radians(195));
  camera.name = "front";
  CHECK_THROWS_WITH(model_label(camera), Catch::StartsWith("lens is not certified: "));
  ModelLabel label = masked_model_label(camera);
  label.part = Part::train;
  label.seed = 11;
  label.vehicle_from_camera = vehicle_from_camera({.pitch_deg = -4});
  CHECK(label.valid == "valid.png");
  CHECK(degrees(label.max_angle_rad) == Approx(115).margin(1e-3));
  CHECK(degrees(label.seen.horizontal_rad.value()) == Approx(195).epsilon(1e-9));
  CHECK(degrees(label.seen.vertical_rad.value()) == Approx(195).epsilon(1e-9));
  CHECK_FALSE(label.seen.diagonal_rad);
  const nlohmann::json json = nlohmann::json::parse(to_json(label).dump());
  CHECK(json["fov_true_deg"]["d"].is_null());
  CHECK(json["valid"] == "valid.png");
  CHECK(json["certificate"]["max_angle_deg"].get<double>() == Approx(115).margin(1e-3));
  const ModelLabel read = model_label_from_json(json, "x");
  CHECK(read.camera == label.camera);
  CHECK(read.valid == label.valid);
  CHECK(read.seen.horizontal_rad.value() == Approx(label.seen.horizontal_rad.value()).epsilon(1e-15));
  CHECK_FALSE(read.seen.diagonal_rad);
  CHECK(read.certificate_min_scale == label.certificate_min_scale);
  CHECK(read.max_angle_rad == Approx(label.max_angle_rad).epsilon(1e-15));
  CHECK(read.vehicle_from_camera.matrix() == label.vehicle_from_camera.matrix());
  CHECK(read.part == Part::train);
  CHECK(read.seed == 11);
  CHECK(read.generator == label.generator);

  const Label common = common_label(label);
  CHECK(common.camera == camera.pinhole);
  CHECK(common.rig_camera == "front");
  CHECK(common.part == Part::train);
}

TEST_CASE("a label of another family with a key that is wrong is refused by the key's name") {
  const ModelCamera camera = *camera_from_seen_hfov(Eucm{.6, 1.1}, 320, 240, radians(120));
  const nlohmann::json good = nlohmann::json::parse(to_json(model_label(camera)).dump());
  CHECK(model_label_from_json(good, "x").camera == camera);
  const auto refusal = [&](const std::function<void(nlohmann::json&)>& damage) -> std::string {
    nlohmann::json json = good;
    damage(json);
    try {
      model_label_from_json(json, "x/calibration.json");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(refusal([](auto& json) { json["model"] = "fov"; }),
             Catch::Contains("x/calibration.json: model"));
  CHECK_THAT(refusal([](auto& json) { json["params"].erase("beta"); }),
             Catch::Contains("params: beta is missing"));
  CHECK_THAT(refusal([](auto& json) { json["params"]["alpha"] = 2; }), Catch::Contains("alpha"));
  CHECK_THAT(refusal([](auto& json) {
               json["gravity"] = {0, 0, 1};
             }),
             Catch::Contains("gravity: contradicts"));
  CHECK_THAT(refusal([](auto& json) { json["valid"] = "mask.png"; }),
             Catch::Contains("valid: must be valid.png"));
  CHECK_THAT(refusal([](auto& json) { json["part"] = "some"; }), Catch::Contains("part"));
  CHECK_THAT(refusal([](auto& json) { json["seed"] = "many"; }), Catch::Contains("seed: "));
  CHECK_THAT(refusal([](auto& json) { json["schema"] = 9; }), Catch::Contains("schema: "));
  CHECK_THAT(refusal([](auto& json) { json.erase("certificate"); }),
             Catch::Contains("certificate: is missing"));
}

TEST_CASE("a dataset with lenses of two families is read by who asks for any") {
  const TemporaryFolder folder;
  ModelCamera sphere = *camera_from_seen_hfov(UnifiedSpherical{.xi = .9}, 320, 240, radians(140));
  sphere.name = "front";
  write_json(folder.path / "set/front_lens0001/calibration.json", to_json(model_label(sphere)));
  Label plane;
  plane.camera = pinhole_from_hfov(320, 240, radians(80));
  plane.fov_base_deg = 80;
  plane.rig_camera = "front";
  write_json(folder.path / "set/front_lens0000/calibration.json", to_json(plane));
  for (const char* part : {"train", "val", "test"})
    write_file(folder.path / "splits" / (std::string(part) + ".txt"),
               std::string("set/front_lens0000/000000.png\nset/front_lens0001/000000.png\n"));
  CHECK_THROWS_WITH(read_dataset(folder.path),
                    Catch::Contains("front_lens0001") && Catch::Contains("model: is unified_spherical"));
  const Dataset dataset = read_dataset(folder.path, LensFamilies::any);
  REQUIRE(dataset.groups.size() == 2);
  CHECK_FALSE(dataset.groups[0].model);
  CHECK(dataset.groups[0].camera().pinhole == plane.camera);
  REQUIRE(dataset.groups[1].model);
  CHECK(dataset.groups[1].camera() == sphere);
  CHECK(dataset.groups[1].label.camera == sphere.pinhole);
  CHECK(dataset.groups[1].label.rig_camera == "front");
}
