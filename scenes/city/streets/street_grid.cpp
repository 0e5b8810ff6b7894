#include "scenes/city/streets/street_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/draws.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_profiles.h"

/// The streets are two families of lines, straight or gently bent, with some pieces left out.
namespace cps::city {
namespace {

constexpr double rim_depth_m = 46;  // depth of the blocks outside the outermost streets
constexpr double bend_step_m = 6;

/// across = base + slope · along + amplitude · sin(wave · along + phase)
struct GridLine {
  double base = 0, slope = 0, amplitude = 0, wave = 0, phase = 0;
  StreetProfile profile;
  double operator()(double along) const {
    return base + slope * along + amplitude * std::sin(wave * along + phase);
  }
};

std::vector<GridLine> draw_lines(Stream family, int count, double extent, double waviness, CityStyle style) {
  Draws spacing{substream(family, 0)};
  std::vector<double> gaps(count - 1);
  double sum = 0;
  for (double& gap : gaps) sum += gap = spacing.uniform(0.75, 1.5);
  const double fan = spacing.uniform(-0.07, 0.07);
  std::vector<GridLine> lines(count);
  double at = -extent / 2;
  for (int i = 0; i < count; ++i) {
    const bool ring = i == 0 || i + 1 == count;
    Draws draws{substream(family, 1 + i)};
    GridLine& line = lines[i];
    line.base = at;
    line.slope = fan * at / (extent / 2) + draws.uniform(-0.02, 0.02);
    if (!ring && draws.chance(waviness)) {
      line.amplitude = draws.uniform(3, 9);
      line.wave = 2 * std::numbers::pi / draws.uniform(240, 520);
      line.phase = draws.uniform(0, 2 * std::numbers::pi);
    }
    line.profile = draw_street_profile(draws, style, ring);
    if (i + 1 < count) at += gaps[i] * extent / sum;
  }
  return lines;
}

bool too_close(const std::vector<GridLine>& lines, double extent, double min_gap_m) {
  for (std::size_t i = 1; i < lines.size(); ++i)
    for (double along = -extent / 2; along <= extent / 2; along += 5)
      if (lines[i](along) - lines[i - 1](along) < min_gap_m) return true;
  return false;
}

/// Moves the lines towards a regular grid until neighbours are at least `min_gap_m` apart.
void keep_apart(std::vector<GridLine>& lines, double extent, double min_gap_m) {
  while (too_close(lines, extent, min_gap_m))
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double even = extent * (static_cast<double>(i) / (lines.size() - 1) - 0.5);
      lines[i].base += 0.25 * (even - lines[i].base);
      lines[i].slope *= 0.75;
      lines[i].amplitude *= 0.75;
    }
}

struct Grid {
  std::vector<GridLine> rows, columns;  // y as a function of x, x as a function of y
  int columns_count() const { return static_cast<int>(columns.size()); }
  int node(int row, int column) const { return row * columns_count() + column; }

  Vec2 crossing(int row, int column) const {
    Vec2 p(columns[column].base, rows[row].base);
    for (int i = 0; i < 60; ++i)
      p = Vec2(columns[column](p.y()), rows[row](p.x()));  // converges, as slopes are far below 1
    return p;
  }
};

Polyline piece_of(const GridLine& line, bool is_row, const Vec2& from, const Vec2& to) {
  if (line.amplitude == 0) return {from, to};
  const double a = is_row ? from.x() : from.y(), b = is_row ? to.x() : to.y();
  const double straight_end_m = std::clamp(0.36 * (b - a), 18.0, 32.0);  // junctions lie on straight pieces
  const int steps = std::max(1, static_cast<int>((b - a - 2 * straight_end_m) / bend_step_m));
  Polyline points{from};
  for (int i = 0; i <= steps; ++i) {
    const double along = a + straight_end_m + (b - a - 2 * straight_end_m) * i / steps;
    points.push_back(is_row ? Vec2(along, line(along)) : Vec2(line(along), along));
  }
  points.push_back(to);
  return points;
}

/// Lays the segments of grid lines, leaving some out, and names the streets that remain.
class StreetLayer {
 public:
  StreetLayer(StreetNetwork& network, const Grid& grid, std::vector<int>& degree)
      : network(network), grid(grid), degree(degree) {}

  void lay(int index, bool is_row, const std::string& name, Stream omissions, double omission_rate) {
    const GridLine& line = is_row ? grid.rows[index] : grid.columns[index];
    const int last_line = static_cast<int>(is_row ? grid.rows.size() : grid.columns.size()) - 1;
    const int pieces = static_cast<int>(is_row ? grid.columns.size() : grid.rows.size()) - 1;
    int run = 0;
    bool open = false;
    for (int k = 0; k < pieces; ++k) {
      const int from = is_row ? grid.node(index, k) : grid.node(k, index);
      const int to = is_row ? grid.node(index, k + 1) : grid.node(k + 1, index);
      const bool inner = index > 0 && index < last_line && k > 0 && k + 1 < pieces;
      if (inner && degree[from] == 4 && degree[to] == 4 && random_uniform(omissions, k) < omission_rate) {
        --degree[from];
        --degree[to];
        open = false;
        continue;
      }
      if (!open) {
        network.streets.push_back({name + "-" + std::to_string(++run), line.profile, {}});
        open = true;
      }
      Segment segment;
      segment.street = static_cast<int>(network.streets.size()) - 1;
      segment.from = from;
      segment.to = to;
      segment.centre =
          piece_of(line, is_row, network.junctions[from].position, network.junctions[to].position);
      segment.half_width = line.profile.half_width();
      network.streets.back().segments.push_back(static_cast<int>(network.segments.size()));
      network.segments.push_back(std::move(segment));
    }
  }

 private:
  StreetNetwork& network;
  const Grid& grid;
  std::vector<int>& degree;
};

void add_rim(StreetNetwork& network, const Grid& grid) {
  const int rows = static_cast<int>(grid.rows.size()), columns = grid.columns_count();
  const std::array<int, 4> inner{grid.node(0, 0), grid.node(0, columns - 1), grid.node(rows - 1, columns - 1),
                                 grid.node(rows - 1, 0)};
  const std::array<Vec2, 4> outwards{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};
  const int first = static_cast<int>(network.junctions.size());
  const auto add_border = [&](int from, int to) {
    Segment border;
    border.from = from;
    border.to = to;
    border.centre = {network.junctions[from].position, network.junctions[to].position};
    network.segments.push_back(std::move(border));
  };
  for (int c = 0; c < 4; ++c) {
    network.junctions.push_back(
        {network.junctions[inner[c]].position + outwards[c] * rim_depth_m, {}, {}, {}});
    network.rim.push_back(network.junctions.back().position);
    add_border(inner[c], first + c);
  }
  for (int c = 0; c < 4; ++c) add_border(first + c, first + (c + 1) % 4);
}

void rotate(StreetNetwork& network, double angle_rad) {
  const auto turn = [c = std::cos(angle_rad), s = std::sin(angle_rad)](Vec2& p) {
    p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  for (Junction& junction : network.junctions) turn(junction.position);
  for (Segment& segment : network.segments)
    for (Vec2& p : segment.centre) turn(p);
  for (Vec2& p : network.rim) turn(p);
}

}  // namespace

StreetNetwork draw_street_network(const CityOptions& options) {
  Draws draws{make_stream(options.seed, "streets")};
  const double extent = options.extent_m;
  const StreetPattern pattern = street_pattern(options.style);
  const double waviness = draws.chance(pattern.straight_share) ? 0.0 : draws.uniform(0.2, 0.7);
  const double omission_rate = draws.uniform(0.05, 0.3);
  const auto line_count = [&] {
    return 1 + std::max(pattern.min_blocks, static_cast<int>(extent / draws.uniform(pattern.spacing_min_m,
                                                                                    pattern.spacing_max_m)));
  };
  Grid grid;
  const int rows = line_count(), columns = line_count();
  grid.rows = draw_lines(make_stream(options.seed, "rows"), rows, extent, waviness, options.style);
  grid.columns = draw_lines(make_stream(options.seed, "columns"), columns, extent, waviness, options.style);
  keep_apart(grid.rows, extent, pattern.min_gap_m);
  keep_apart(grid.columns, extent, pattern.min_gap_m);

  StreetNetwork network;
  std::vector<int> degree;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      network.junctions.push_back({grid.crossing(r, c), {}, {}, {}});
      const bool inner = r > 0 && r + 1 < rows && c > 0 && c + 1 < columns;
      degree.push_back(inner ? 4 : 3);
    }
  StreetLayer layer(network, grid, degree);
  const Stream omissions = make_stream(options.seed, "omitted segments");
  for (int r = 0; r < rows; ++r)
    layer.lay(r, true, std::string{static_cast<char>('A' + r)}, substream(omissions, 2 * r), omission_rate);
  for (int c = 0; c < columns; ++c)
    layer.lay(c, false, std::to_string(c + 1), substream(omissions, 2 * c + 1), omission_rate);
  add_rim(network, grid);
  rotate(network, draws.uniform(0, 2 * std::numbers::pi));
  find_blocks(network);
  shape_junctions(network, options);
  return network;
}

}  // namespace cps::city
