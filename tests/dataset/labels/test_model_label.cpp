#include <catch2/catch.hpp>
#include <cmath>

#include "dataset/exchange/model_calibration.h"
#include "dataset/labels/label.h"
#include "dataset/labels/model_label.h"
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
