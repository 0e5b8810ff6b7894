#include "scenes/drive/route_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace cps {
namespace {

constexpr double stretch_m = 60;
constexpr int min_stretches = 3;  ///< one each for train, val and test
constexpr float half_place_m = 0.05f;

struct RoutePoint {
  Eigen::Vector3d position;
  std::optional<double> heading_rad;
};

[[noreturn]] void refuse(const std::filesystem::path& file, int line, const std::string& what) {
  throw std::runtime_error(file.string() + ": line " + std::to_string(line) + ": " + what);
}

/// The comma-separated numbers of a line; none if a field is not a finite number.
std::optional<std::vector<double>> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const char *first = line.data() + begin, *last = line.data() + end;
    while (first < last && (*first == ' ' || *first == '\t')) ++first;
    while (first < last && (last[-1] == ' ' || last[-1] == '\t' || last[-1] == '\r')) --last;
    double number = 0;
    const auto [stop, error] = std::from_chars(first, last, number);
    if (error != std::errc() || stop != last || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    begin = end + 1;
  }
  return numbers;
}

std::vector<RoutePoint> read_points(const std::filesystem::path& file, const FileFrame& frame) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw std::runtime_error(file.string() + ": cannot be read; name a route file, lines of x,y,z");
  std::vector<RoutePoint> points;
  std::size_t columns = 0;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto values = numbers_of(line);
    if (!values && number == 1) continue;  // column names
    if (!values || (values->size() != 3 && values->size() != 4) || (columns && values->size() != columns))
      refuse(file, number, "must be x,y,z or x,y,z,heading_deg, numbers, the same on every line");
    columns = values->size();
    Eigen::Vector3d at((*values)[0], (*values)[1], (*values)[2]);
    if (frame.is_z_up) at = {at.x(), at.z(), -at.y()};
    RoutePoint point{.position = at * frame.metres_per_unit - frame.origin, .heading_rad = std::nullopt};
    if (!(point.position.norm() < 1e7)) refuse(file, number, "lies beyond 10,000 km");
    // Not by radians(), which rounds π / 180 first: datasets keep their bytes.
    if (columns == 4) point.heading_rad = (*values)[3] * std::numbers::pi / 180;
    const bool repeats =
        !points.empty() && !point.heading_rad && (point.position - points.back().position).norm() < 1e-3;
    if (!repeats) points.push_back(point);
  }
  if (points.size() < (columns == 4 ? 1 : 2))
    throw std::runtime_error(file.string() + ": holds too few points to drive along");
  return points;
}

/// Street name of a stretch of the route.
std::string stretch_name(int stretch) {
  return "stretch " + std::to_string(stretch + 1);
}

/// A lane 0.1 m long around each point.
std::vector<Lane> lanes_at(const std::vector<RoutePoint>& points, int stretches) {
  std::vector<Lane> lanes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double heading = *points[i].heading_rad;
    const Eigen::Vector3f half =
        half_place_m * Eigen::Vector3d(std::cos(heading), 0, -std::sin(heading)).cast<float>();
    const Eigen::Vector3f at = points[i].position.cast<float>();
    Lane lane;
    lane.street = stretch_name(static_cast<int>(i * stretches / points.size()));
    lane.points = {at - half, at + half};
    if (i + 1 < points.size()) lane.next = {static_cast<int>(i + 1)};
    lanes.push_back(std::move(lane));
  }
  // The last lane leads to itself, so that it does not count as a dead end: it is a place like the others.
  lanes.back().next = {static_cast<int>(lanes.size()) - 1};
  lanes.front().next.push_back(0);
  return lanes;
}

/// One lane through the points, cut into stretches of equal length.
std::vector<Lane> lanes_through(const std::vector<RoutePoint>& points, int stretches, double whole_m) {
  std::vector<Lane> lanes(1);
  double driven_m = 0;
  lanes[0].points.push_back(points[0].position.cast<float>());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector3d from = points[i - 1].position, to = points[i].position;
    const double piece_m = (to - from).norm();
    while (static_cast<int>(lanes.size()) < stretches) {
      const double cut_m = whole_m * static_cast<double>(lanes.size()) / stretches;
      if (driven_m + piece_m <= cut_m) break;
      const Eigen::Vector3f cut = (from + (to - from) * (cut_m - driven_m) / piece_m).cast<float>();
      if (cut != lanes.back().points.back()) lanes.back().points.push_back(cut);
      lanes.emplace_back().points.push_back(cut);
    }
    driven_m += piece_m;
    const Eigen::Vector3f end = to.cast<float>();
    if (end != lanes.back().points.back()) lanes.back().points.push_back(end);
  }
  std::erase_if(lanes, [](const Lane& lane) { return lane.points.size() < 2; });
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    lanes[i].street = stretch_name(static_cast<int>(i));
    if (i + 1 < lanes.size()) lanes[i].next = {static_cast<int>(i + 1)};
  }
  return lanes;
}

}  // namespace

std::vector<Lane> read_route(const std::filesystem::path& file, const FileFrame& frame) {
  const std::vector<RoutePoint> points = read_points(file, frame);
  double whole_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    whole_m += (points[i].position - points[i - 1].position).norm();
  const int stretches =
      std::max(min_stretches, static_cast<int>(std::min(std::floor(whole_m / stretch_m), 1000.0)));
  return points[0].heading_rad ? lanes_at(points, stretches) : lanes_through(points, stretches, whole_m);
}

}  // namespace cps
