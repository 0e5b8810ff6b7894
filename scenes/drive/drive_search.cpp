#include "scenes/drive/drive_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numbers/angles.h"
#include "random/counter_hash.h"

namespace cps {
namespace {

constexpr int max_drives = 60, candidates = 200, headings = 24;
constexpr double half_car_m = 1.2;  ///< half a car's width and a margin
constexpr double apart_m = 3;       ///< between drives
constexpr double min_length_m = 4, max_length_m = 120, sight_m = 60;
constexpr double step_m = 1;
constexpr double min_share_of_first = 0.6;  ///< of the first drive's score: what is left are corners
constexpr double sides_worth_m = 40;        ///< metres of free way that are worth things all along both sides

struct Walker {
  Eigen::Vector2d point;  ///< x, z
  double heading = 0;     ///< about +y, 0 along +x, growing to the left
};

Eigen::Vector2d ahead(double heading) {
  return {std::cos(heading), -std::sin(heading)};
}

/// The cells within `apart_m` of a drive.
class Taken {
 public:
  explicit Taken(const GroundGrid& grid) : grid_(grid), cells_(grid.height.size(), 0) {}
  bool contains(const Eigen::Vector2d& point) const {
    const int cell = grid_.cell_at(point);
    return cell < 0 || cells_[cell];
  }
  void add(const Eigen::Vector2d& point) {
    const int reach = static_cast<int>(std::ceil(apart_m / grid_.cell_m));
    const Eigen::Vector2d at = (point - grid_.corner) / grid_.cell_m;
    const int cx = static_cast<int>(std::lround(at.x())), cz = static_cast<int>(std::lround(at.y()));
    for (int z = std::max(cz - reach, 0); z <= std::min(cz + reach, grid_.nz - 1); ++z)
      for (int x = std::max(cx - reach, 0); x <= std::min(cx + reach, grid_.nx - 1); ++x)
        if (std::hypot(x - cx, z - cz) * grid_.cell_m <= apart_m) cells_[grid_.index(x, z)] = 1;
  }

 private:
  const GroundGrid& grid_;
  std::vector<std::uint8_t> cells_;
};

/// How far a car can drive straight ahead, at most `sight_m`.
double free_way_m(const GroundGrid& ground, const Taken& taken, const Walker& walker) {
  double way_m = 0;
  for (const double step = std::max(0.5, ground.cell_m / 2); way_m < sight_m; way_m += step) {
    const Eigen::Vector2d point = walker.point + (way_m + step) * ahead(walker.heading);
    if (ground.room_at(point) < half_car_m || ground.around_at(point).share() < few_things ||
        taken.contains(point))
      break;
  }
  return way_m;
}

struct Start {
  Walker walker{Eigen::Vector2d::Constant(NAN)};
  double score = 0;  ///< 0: there is none
};

/// Of `candidates` random places on free ground, the place and heading with the longest way ahead, the most
/// room and the most things beside it.
Start best_start(const GroundGrid& ground, const Taken& taken, const std::vector<int>& free,
                 bool needs_both_sides, Stream stream) {
  Start best;
  for (int i = 0; i < candidates; ++i) {
    const int cell = free[random_below(stream, i, free.size())];
    Walker walker{ground.corner + ground.cell_m * Eigen::Vector2d(cell % ground.nx, cell / ground.nx)};
    if (taken.contains(walker.point)) continue;
    for (int h = 0; h < headings; ++h) {
      walker.heading = 2 * std::numbers::pi * h / headings;
      // Prefers the middle of a road to its edge, and having things on both sides.
      const Surroundings around = ground.around_at(walker.point);
      const double sides = around.on_both_sides(walker.heading);
      if (!(around.ahead(walker.heading) > 0) || (needs_both_sides && !(sides > 0))) continue;
      const double score = free_way_m(ground, taken, walker) +
                           2 * std::min(ground.room_at(walker.point), 4.0) + sides_worth_m * sides;
      if (score > best.score) best = {walker, score};
    }
  }
  return best;
}

/// Ends where a driver has seen nothing ahead for ten metres, or on one side if it needs both.
std::vector<Eigen::Vector2d> walk(const GroundGrid& ground, const Taken& taken, bool needs_both_sides,
                                  Walker walker) {
  constexpr int max_bare_steps = 10;
  int bare_steps = 0;
  std::vector<Eigen::Vector2d> path = {walker.point};
  while (path.size() * step_m < max_length_m) {
    Walker best = walker;
    double best_score = -1, best_way_m = 0;
    for (const double turn_deg : {0.0, 5.0, -5.0, 10.0, -10.0}) {
      Walker next{walker.point, walker.heading + radians(turn_deg)};
      const double way_m = free_way_m(ground, taken, next);
      next.point += step_m * ahead(next.heading);
      const double score = std::min(way_m, 30.0) + 3 * std::min(ground.room_at(next.point), 4.0) -
                           0.2 * std::abs(turn_deg) +
                           10 * ground.around_at(next.point).on_both_sides(next.heading);
      if (score > best_score) best = next, best_score = score, best_way_m = way_m;
    }
    if (best_way_m < 2 * step_m) break;
    walker = best;
    path.push_back(walker.point);
    const Surroundings around = ground.around_at(walker.point);
    const bool is_bare = !(around.ahead(walker.heading) > 0) ||
                         (needs_both_sides && !(around.on_both_sides(walker.heading) > 0));
    bare_steps = is_bare ? bare_steps + 1 : 0;
    if (bare_steps == max_bare_steps) break;
  }
  path.resize(path.size() - std::min<std::size_t>(bare_steps, path.size() - 1));
  return path;
}

}  // namespace

std::vector<Lane> find_drives(const GroundGrid& ground) {
  std::vector<int> free;
  for (int cell = 0; cell < ground.nx * ground.nz; ++cell)
    if (ground.room_m[cell] >= half_car_m && ground.around[cell].share() >= few_things) free.push_back(cell);
  std::vector<Lane> drives;
  Taken taken(ground);
  const Stream stream = make_stream(0, "drives");
  bool needs_both_sides = true;
  double first_score = 0;
  for (int drive = 0; drive < max_drives && !free.empty(); ++drive) {
    const auto [start, score] = best_start(ground, taken, free, needs_both_sides, substream(stream, drive));
    if (!(score > min_length_m) || score < min_share_of_first * first_score) {
      if (!needs_both_sides || !drives.empty()) break;
      needs_both_sides = false;  // a street with houses along one side is better than none
      continue;
    }
    first_score = std::max(first_score, score);
    const std::vector<Eigen::Vector2d> path = walk(ground, taken, needs_both_sides, start);
    for (const Eigen::Vector2d& point : path) taken.add(point);
    if ((path.size() - 1) * step_m < min_length_m) continue;
    Lane& lane = drives.emplace_back();
    lane.street = "drive " + std::to_string(drives.size());
    for (const Eigen::Vector2d& point : path) lane.points.push_back(ground.ground_at(point).cast<float>());
  }
  return drives;
}

}  // namespace cps
