#include "trainer/evaluation/camera_numbers.h"

#include <array>

#include "numbers/angles.h"

namespace cps {
namespace {

double same_unit(const CalibratedCamera&) {
  return 1;
}

constexpr std::array<CameraNumber, output_count> numbers_of_camera{{
    {"H-FOV", "deg", [](const CalibratedCamera& c) { return degrees(hfov_rad(c.pinhole)); },
     [](const CalibratedCamera&) { return degrees(1); }},
    {"k1", "", [](const CalibratedCamera& c) { return c.distortion.k1; }, same_unit},
    {"k2", "", [](const CalibratedCamera& c) { return c.distortion.k2; }, same_unit},
    {"k3", "", [](const CalibratedCamera& c) { return c.distortion.k3; }, same_unit},
    {"p1", "", [](const CalibratedCamera& c) { return c.distortion.p1; }, same_unit},
    {"p2", "", [](const CalibratedCamera& c) { return c.distortion.p2; }, same_unit},
    {"cx", "px", [](const CalibratedCamera& c) { return c.pinhole.cx; },
     [](const CalibratedCamera& c) { return double(c.pinhole.width); }},
    {"cy", "px", [](const CalibratedCamera& c) { return c.pinhole.cy; },
     [](const CalibratedCamera& c) { return double(c.pinhole.height); }},
}};

}  // namespace

std::span<const CameraNumber, output_count> camera_numbers() {
  return numbers_of_camera;
}

nlohmann::ordered_json numbers_json(const CalibratedCamera& camera) {
  nlohmann::ordered_json json;
  for (int i = 0; i < output_count; ++i) json[output_names[i]] = numbers_of_camera[i].value(camera);
  return json;
}

nlohmann::ordered_json numbers_json(const Outputs& raw, const ImageSize& size) {
  const CalibratedCamera of_size{"", {.width = size.width, .height = size.height}, {}};
  nlohmann::ordered_json json;
  for (int i = 0; i < output_count; ++i)
    json[output_names[i]] = raw[i] * numbers_of_camera[i].unit_of_raw(of_size);
  return json;
}

}  // namespace cps
