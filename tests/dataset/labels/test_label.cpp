#include <catch2/catch.hpp>
#include <cmath>

#include "dataset/labels/label.h"
#include "scenes/rig.h"
#include "tests/dataset/labels/old_label.h"

using namespace cps;

namespace {

Label sample_label() {
  Label label;
  label.camera = pinhole_from_hfov(1392, 512, 1.3);
  label.camera.cx += 11.3;
  label.camera.cy -= 7.7;
  label.distortion = {
      .k1 = -0.3728755, .k2 = 0.2037299, .k3 = -0.07233722, .p1 = 0.002219027, .p2 = 0.001383707};
  label.fov_base_deg = 86.3;
  label.fov_true_h_deg = 83.0, label.fov_true_v_deg = 30.0, label.fov_true_d_deg = 90.0;
  label.zoom = 1.21;
  label.certificate_min_eigenvalue = 0.386;
  label.limits[0] = Interval{.low = -0.5, .high = 0.1};
  label.rig_camera = "front";
  label.vehicle_from_camera.translation() = Eigen::Vector3d(1.68, 0, 1.65);
  label.part = Part::val;
  label.seed = 18446744073709551615ull;
  label.generator = "cps 0";
  return label;
}

std::string refusal(const nlohmann::json& json) {
  try {
    label_from_json(json, "x/calibration.json");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a label written as JSON text reads back to the same bits") {
  const Label label = sample_label();
  const Label read = label_from_json(nlohmann::json::parse(to_json(label).dump(2)), "x");
  CHECK(read.camera == label.camera);
  CHECK(read.distortion == label.distortion);
  CHECK(read.fov_base_deg == label.fov_base_deg);
  CHECK(read.limits[0]->low == -0.5);
  CHECK_FALSE(read.limits[1].has_value());
  CHECK(read.vehicle_from_camera.matrix() == label.vehicle_from_camera.matrix());
  CHECK(read.part == Part::val);
  CHECK(read.seed == label.seed);
  CHECK(to_json(read).dump() == to_json(label).dump());
}

TEST_CASE("a label reads back from the form of each schema") {
  const Label label = sample_label();
  for (int schema : {1, 2}) {
    const std::string text = to_json(label, schema).dump(2);
    const nlohmann::json json = nlohmann::json::parse(text);
    CHECK(json["schema"] == schema);
    CHECK(json.contains("gravity") == (schema == 2));
    const Label read = label_from_json(json, "x");
    CHECK(to_json(read, schema).dump(2) == text);
    CHECK(to_json(read).dump() == to_json(label).dump());
  }
}

TEST_CASE("a file of schema 1 reads, and can be written again to the byte") {
  const Label label = label_from_json(nlohmann::json::parse(old_label), "x");
  CHECK(label.distortion.k1 == -0.48237934985647657);
  CHECK(label.part == Part::test);
  CHECK(nominal_gravity(label) == Eigen::Vector3d(0, 1, 0));
  CHECK(to_json(label, 1).dump(2) + "\n" == old_label);
}

TEST_CASE("gravity is where the camera's mounting puts it, in closed form") {
  const auto gravity = [](const RigCamera& camera) {
    Label label;
    label.vehicle_from_camera = vehicle_from_camera(camera);
    return nominal_gravity(label);
  };
  const double a = 25 * M_PI / 180, r = 40 * M_PI / 180;
  CHECK(gravity({}) == Eigen::Vector3d(0, 1, 0));
  using Vector = Eigen::Vector3d;
  const auto differ = [&](const RigCamera& camera, const Vector& expected) {
    return (gravity(camera) - expected).norm();
  };
  CHECK(differ({.yaw_deg = 75}, {0, 1, 0}) < 1e-14);
  CHECK(differ({.pitch_deg = 25}, {0, std::cos(a), -std::sin(a)}) < 1e-14);  // seen upwards: it lies behind
  CHECK(differ({.pitch_deg = -90}, {0, 0, 1}) < 1e-14);
  CHECK(differ({.roll_deg = 40}, {std::sin(r), std::cos(r), 0}) < 1e-14);  // the right side is the lower
  CHECK(differ({.yaw_deg = -130, .pitch_deg = 25, .roll_deg = 40},
               {std::sin(r) * std::cos(a), std::cos(r) * std::cos(a), -std::sin(a)}) < 1e-14);
}

TEST_CASE("the keys that other readers use are there and consistent") {
  const nlohmann::json json = nlohmann::json::parse(to_json(sample_label()).dump());
  for (const char* key :
       {"fov",    "K",      "width", "height", "k1",           "k2",           "k3",   "p1",
        "p2",     "cx",     "cy",    "schema", "fov_base_deg", "fov_true_deg", "crop", "certificate",
        "limits", "camera", "part",  "seed",   "generator",    "gravity"})
    CHECK(json.contains(key));
  const double fov = json["fov"].get<double>() * M_PI / 180;
  CHECK(json["K"][0][0].get<double>() == Approx(1392 / (2 * std::tan(fov / 2))).epsilon(1e-12));
  CHECK(json["K"][0][2] == json["cx"]);
  CHECK(json["K"][1][2] == json["cy"]);
  CHECK(json["K"][2][2] == 1.0);
  CHECK(json["p1"] == 0.002219027);
  CHECK(json["p2"] == 0.001383707);
}

TEST_CASE("a label that contradicts itself or lacks a key is refused by key") {
  const nlohmann::json good = nlohmann::json::parse(to_json(sample_label()).dump());
  CHECK(refusal(good).empty());
  const auto changed = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json json = good;
    json[nlohmann::json::json_pointer(pointer)] = value;
    return refusal(json);
  };
  CHECK_THAT(changed("/fov", 70.0), Catch::Contains("x/calibration.json: fov"));
  CHECK_THAT(changed("/cx", 0.0), Catch::Contains("cx: contradicts"));
  CHECK_THAT(changed("/cy", 0.0), Catch::Contains("cy: contradicts"));
  CHECK_THAT(changed("/width", -1), Catch::Contains("width"));
  CHECK_THAT(changed("/K", {1, 2, 3}), Catch::Contains("K"));
  CHECK_THAT(changed("/K/0/0", 0.0), Catch::Contains("K"));
  CHECK_THAT(changed("/k2", nullptr), Catch::Contains("k2: must be a number"));
  for (double schema : {0., 1.5, 3., 99.})
    CHECK_THAT(changed("/schema", schema),
               Catch::StartsWith("x/calibration.json: schema: is neither 1 nor 2"));
  CHECK_THAT(changed("/gravity/0", 1e-5),
             Catch::StartsWith("x/calibration.json: gravity: contradicts T_vehicle_camera"));
  CHECK(changed("/gravity/0", 1e-7).empty());
  CHECK_THAT(changed("/gravity", {0, 1}), Catch::Contains("gravity: must be 3 numbers"));
  CHECK_THAT(changed("/camera/T_vehicle_camera/2/1", .1), Catch::Contains("gravity: contradicts"));
  CHECK_THAT(changed("/part", "training"), Catch::Contains("training"));
  CHECK_THAT(changed("/limits/k1", "wide"), Catch::Contains("k1"));
  CHECK_THAT(changed("/camera/T_vehicle_camera", 3), Catch::Contains("T_vehicle_camera"));
  for (const auto& [key, value] : good.items()) {
    nlohmann::json json = good;
    json.erase(key);
    CHECK_THAT(refusal(json), Catch::Contains(key + ": is missing"));
  }
}
