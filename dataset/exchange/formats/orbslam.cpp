#include <algorithm>
#include <array>

#include "dataset/exchange/formats/formats.h"

/// ORB-SLAM's settings: flat keys `Camera.fx` (version 2), `Camera1.fx` and `Camera2.fx` (version 3) with
/// k1 k2 p1 p2 and perhaps k3; Camera.type KannalaBrandt8: k1 k2 k3 k4. Sizes are Camera.width,
/// Camera.height, which version 2 may leave out.
namespace cps {
namespace {

constexpr std::array prefixes{"Camera.", "Camera1.", "Camera2."};

LensModel read_lens(const JsonKeys& keys) {
  if (named_lens(keys, {NamedLens::plane, NamedLens::kannala_brandt}) == NamedLens::kannala_brandt) {
    refuse_other_coefficients(keys, {"k1", "k2", "k3", "k4"});
    return KannalaBrandt{
        .k1 = keys.number("k1"), .k2 = keys.number("k2"), .k3 = keys.number("k3"), .k4 = keys.number("k4")};
  }
  refuse_other_coefficients(keys, {"k1", "k2", "k3", "p1", "p2"});
  const auto optional = [&](const char* key) { return keys.json.contains(key) ? keys.number(key) : 0.0; };
  return Distortion{.k1 = optional("k1"),
                    .k2 = optional("k2"),
                    .k3 = optional("k3"),
                    .p1 = optional("p1"),
                    .p2 = optional("p2")};
}

ModelCamera read_orbslam_camera(const JsonKeys& root, const std::string& prefix) {
  // Only this camera's keys, without their prefix; what both cameras share (type, size) stands under
  // `Camera.`.
  constexpr std::array own_to_each{"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2"};
  nlohmann::json own = nlohmann::json::object();
  for (const auto& [key, value] : root.json.items())
    if (key.starts_with("Camera.") &&
        std::find(own_to_each.begin(), own_to_each.end(), key.substr(7)) == own_to_each.end())
      own[key.substr(7)] = value;
  for (const auto& [key, value] : root.json.items())
    if (key.starts_with(prefix)) own[key.substr(prefix.size())] = value;
  const std::string where = root.file + ": " + prefix.substr(0, prefix.size() - 1);
  const JsonKeys keys{own, where};
  return {prefix.substr(0, prefix.size() - 1),
          {.width = own.contains("width") ? size_px(keys.number("width"), where + ": width") : 0,
           .height = own.contains("height") ? size_px(keys.number("height"), where + ": height") : 0,
           .fx = keys.number("fx"),
           .fy = keys.number("fy"),
           .cx = keys.number("cx"),
           .cy = keys.number("cy")},
          read_lens(keys)};
}

}  // namespace

bool is_orbslam(const nlohmann::json& json) {
  for (const std::string prefix : prefixes)
    if (json.contains(prefix + "fx")) return true;
  return json.contains("Camera.type");
}

ModelCalibrationFile read_orbslam(const JsonKeys& root) {
  ModelCalibrationFile file;
  for (const std::string prefix : prefixes)
    if (root.json.contains(prefix + "fx"))
      add_camera(file, prefix.substr(0, prefix.size() - 1),
                 [&] { return read_orbslam_camera(root, prefix); });
  if (file.cameras.empty() && file.unread.empty())
    add_camera(file, "Camera", [&] { return read_orbslam_camera(root, "Camera."); });
  return file;
}

}  // namespace cps
