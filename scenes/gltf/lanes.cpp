#include "scenes/gltf/lanes.h"

#include <algorithm>
#include <cmath>

namespace cps::gltf {
namespace {

Eigen::Vector3f read_point(const Document& document, const tinygltf::Value& value,
                           const Eigen::Vector3d& origin, const std::string& where) {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  bool valid = value.ArrayLen() == 3;
  for (int c = 0; c < 3 && valid; ++c) {
    valid = value.Get(c).IsNumber();
    point[c] = static_cast<float>(value.Get(c).GetNumberAsDouble() - origin[c]);
  }
  if (!valid || !point.allFinite())
    refuse(document, where, "must be three finite numbers: x, y, z in metres");
  return point;
}

/// Street names end up in CSV files and on the terminal, a line each.
bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

Lane read_lane(const Document& document, const tinygltf::Value& value, const Eigen::Vector3d& origin,
               const std::string& where) {
  if (!value.IsObject() || !value.Has("street") || !value.Get("street").IsString())
    refuse(document, where + ".street", "must be the name of the lane's street");
  Lane lane;
  lane.street = value.Get("street").Get<std::string>();
  if (has_control_character(lane.street))
    refuse(document, where + ".street", "holds a line break or another control character: rename the street");
  if (value.Has("width_m")) {
    lane.width_m =
        static_cast<float>(value.Get("width_m").IsNumber() ? value.Get("width_m").GetNumberAsDouble() : 0);
    if (!(lane.width_m >= 1 && lane.width_m <= 20))
      refuse(document, where + ".width_m", "must be 1 to 20 metres");
  }
  const tinygltf::Value& points = value.Get("points");
  for (std::size_t i = 0; i < points.ArrayLen(); ++i) {
    const std::string name = where + "." + element("points", i);
    lane.points.push_back(read_point(document, points.Get(static_cast<int>(i)), origin, name));
    if (i > 0 && lane.points[i] == lane.points[i - 1]) refuse(document, name, "repeats the point before it");
  }
  if (lane.points.size() < 2) refuse(document, where + ".points", "must be at least two points");
  return lane;
}

/// Indices of the lanes that follow this one; empty without `next`.
std::vector<int> read_next(const Document& document, const tinygltf::Value& value, int lane_count,
                           const std::string& where) {
  std::vector<int> next;
  if (!value.Has("next")) return next;
  const tinygltf::Value& list = value.Get("next");
  const auto is_lane = [&](const tinygltf::Value& v) {
    return v.IsInt() && v.GetNumberAsInt() >= 0 && v.GetNumberAsInt() < lane_count;
  };
  bool valid = list.IsArray();
  for (std::size_t i = 0; i < list.ArrayLen() && valid; ++i) {
    valid = is_lane(list.Get(static_cast<int>(i)));
    if (valid) next.push_back(list.Get(static_cast<int>(i)).GetNumberAsInt());
  }
  if (!valid)
    refuse(document, where + ".next",
           "must be an array of lane numbers, 0 to " + std::to_string(lane_count - 1));
  return next;
}

/// The stretches that vehicles occupy; empty without `occupied`.
std::vector<LaneStretch> read_occupied(const Document& document, const tinygltf::Value& value,
                                       const std::string& where) {
  std::vector<LaneStretch> occupied;
  if (!value.Has("occupied")) return occupied;
  const tinygltf::Value& list = value.Get("occupied");
  bool valid = list.IsArray();
  for (std::size_t i = 0; i < list.ArrayLen() && valid; ++i) {
    const tinygltf::Value& pair = list.Get(static_cast<int>(i));
    valid = pair.ArrayLen() == 2 && pair.Get(0).IsNumber() && pair.Get(1).IsNumber();
    if (!valid) break;
    occupied.push_back({pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()});
    valid = std::isfinite(occupied[i].from_m) && std::isfinite(occupied[i].to_m) &&
            occupied[i].from_m < occupied[i].to_m;
  }
  if (!valid)
    refuse(document, where + ".occupied", "must be an array of pairs [from, to] in metres, from < to");
  return occupied;
}

}  // namespace

std::vector<Lane> read_lanes(const Document& document, int scene, const Eigen::Vector3d& origin) {
  std::vector<Lane> lanes;
  if (scene == -1) return lanes;
  const tinygltf::Value& extras = document.model.scenes[scene].extras;
  if (!extras.Has("cps_lanes")) return lanes;
  const tinygltf::Value& list = extras.Get("cps_lanes");
  const std::string where = element("scenes", scene) + ".extras.cps_lanes";
  if (!list.IsArray()) refuse(document, where, "must be an array of lanes");
  const int count = static_cast<int>(list.ArrayLen());
  for (int i = 0; i < count; ++i) {
    const std::string name = where + "[" + std::to_string(i) + "]";
    lanes.push_back(read_lane(document, list.Get(i), origin, name));
    lanes.back().next = read_next(document, list.Get(i), count, name);
    lanes.back().occupied = read_occupied(document, list.Get(i), name);
  }
  return lanes;
}

}  // namespace cps::gltf
